// The step slider, the explode slider, playing.

const ids = list => list.map(i => model.parts[i].id).join(' ');
function setStep(s, animated) {
  s = Math.max(0, Math.min(last, s));
  const forward = s === state.step + 1 && animated && !still;
  state.step = s;
  slide = 0;
  animations.delete('slide');
  if (s > 0) seeNewParts(animated);
  if (forward && s > 1) {
    slide = 1;
    animate('slide', 900, f => { slide = 1 - f; refresh(); }, () => { slide = 0; refresh(); });
  }
  showStep();
  refresh();
}
function showStep() {
  const s = state.step, step = model.steps[s - 1];
  $('step').value = s;
  $('step-out').textContent = s === 0 ? 'finished' : `${s} of ${last}`;
  $('step-name').textContent = s === 0 ? model.title : `Step ${s}: ${model.parts[step.parts[0]].id}`;
  $('step-text').textContent = s === 0
      ? (last ? 'The finished model. The right arrow key shows the first step.' : 'No order of assembly is known for this model.')
      : model.steps[s - 1].text;
  $('back').disabled = s === 0;
  $('next').disabled = s === last;
  rows.forEach((row, i) => {
    row.classList.toggle('now', i === s - 1);
    row.classList.toggle('later', s > 0 && i > s - 1);
  });
  if (s > 0) rows[s - 1].scrollIntoView({block: 'nearest'});
}
function setExplode(percent) {
  const before = distance();
  state.explode = Math.max(0, Math.min(100, percent));
  camera.position.sub(controls.target).multiplyScalar(distance() / before).add(controls.target);
  controls.update();
  $('explode').value = state.explode;
  $('explode-out').textContent = state.explode + ' %';
  refresh();
}
function setPlaying(on) {
  state.playing = on;
  $('play').textContent = on ? 'Pause' : 'Play';
  if (on && state.step === last) setStep(0, false);
  if (on) advance();
}
function advance() {
  if (!state.playing) return;
  if (state.step === last) return setPlaying(false);
  setStep(state.step + 1, true);
  setTimeout(advance, 1500);
}

const rows = model.steps.map((step, s) => {
  const row = element('button');
  const first = model.parts[step.parts[0]];
  row.append(element('i', s + 1), element('b', first.id), element('span', ids(step.parts.slice(1))));
  row.addEventListener('click', () => setStep(s + 1, true));
  return $('steps').appendChild(row);
});
