// Pointer, search, keys.

const ray = new THREE.Raycaster();
let pressed = null;
function partAt(x, y) {
  const box = $('view').getBoundingClientRect();
  ray.setFromCamera({x: (x - box.left) / box.width * 2 - 1, y: 1 - (y - box.top) / box.height * 2}, camera);
  const hits = ray.intersectObjects(model.parts.filter(p => p.group.visible && !(state.ghost && p.mesh.material[0].transparent))
      .map(p => p.mesh));
  return hits.length ? hits[0].object.userData.part : -1;
}
$('view').addEventListener('pointerdown', e => { pressed = [e.clientX, e.clientY]; animations.delete('camera'); });
$('view').addEventListener('pointerup', e => {
  if (pressed && Math.hypot(e.clientX - pressed[0], e.clientY - pressed[1]) < 5 && e.button === 0) select(partAt(e.clientX, e.clientY), true);
  pressed = null;
});

function found(text) {
  const wanted = text.trim().toUpperCase();
  if (!wanted) return [];
  const digits = /^\d+$/.test(wanted) ? Number(wanted) : -1;
  const rank = p => p.id.toUpperCase() === wanted ? 0 : p.id.toUpperCase().startsWith(wanted) ? 1 :
      digits >= 0 && parseInt(p.id.slice(1), 10) === digits ? 1 : p.id.toUpperCase().includes(wanted) ? 2 : 3;
  return model.parts.map((p, i) => [rank(p), i]).filter(r => r[0] < 3).sort((a, b) => a[0] - b[0] || a[1] - b[1]).slice(0, 8).map(r => r[1]);
}
function showResults() {
  const box = $('results');
  box.textContent = '';
  found($('search').value).forEach((i, k) => {
    const part = model.parts[i], row = element('div', part.id, k === 0 ? 'first' : '');
    row.append(element('span', (part.kind === 'panel' ? 'panel' : 'connector') + (part.sheet >= 0 ? ', sheet ' + (part.sheet + 1) : '')));
    row.addEventListener('mousedown', () => { select(i); $('search').value = ''; showResults(); });
    box.appendChild(row);
  });
}
$('search').addEventListener('input', showResults);
$('search').addEventListener('blur', () => { $('results').textContent = ''; });
$('search').addEventListener('keydown', e => {
  e.stopPropagation();
  if (e.key === 'Enter') {
    const hits = found($('search').value);
    if (hits.length) select(hits[0]);
  }
  if (e.key === 'Enter' || e.key === 'Escape') {
    $('search').value = '';
    showResults();
    $('view').focus();
  }
});

const toggle = (name, button) => { state[name] = !state[name]; $(button).classList.toggle('on', state[name]); refresh(); };
const keys = {
  ArrowRight: () => setStep(state.step + 1, true), ArrowLeft: () => setStep(state.step - 1, true),
  Home: () => setStep(0, false), End: () => setStep(last, false),
  ArrowUp: () => setExplode(state.explode + 5), ArrowDown: () => setExplode(state.explode - 5),
  ' ': () => setPlaying(!state.playing), '/': () => $('search').focus(), f: () => look(vec(model.view), true),
  l: () => toggle('labels', 'labels-button'), t: () => { if (hasTextures) toggle('textures', 'textures-button'); },
  g: () => toggle('ghost', 'ghost-button'),
  d: () => { document.documentElement.classList.toggle('dark'); refresh(); },
  p: printSteps, '?': () => { if ($('help').showModal) $('help').showModal(); }, Escape: () => select(-1)
};
window.addEventListener('keydown', e => {
  if (e.ctrlKey || e.metaKey || e.altKey || $('help').open) return;
  if (e.target.tagName === 'BUTTON' && (e.key === ' ' || e.key === 'Enter')) return;
  const action = keys[e.key.length === 1 ? e.key.toLowerCase() : e.key];
  if (!action) return;
  e.preventDefault();
  action();
});
document.querySelectorAll('#tools button').forEach(b => b.addEventListener('click', () => { keys[b.dataset.key](); b.blur(); }));
$('help-close').addEventListener('click', () => $('help').close());
$('back').addEventListener('click', () => setStep(state.step - 1, true));
$('next').addEventListener('click', () => setStep(state.step + 1, true));
$('play').addEventListener('click', () => setPlaying(!state.playing));
$('step').addEventListener('input', () => setStep(Number($('step').value), false));
$('explode').addEventListener('input', () => setExplode(Number($('explode').value)));
window.addEventListener('resize', resize);
