// Pictures of all steps, for paper.

/// A picture of the present state.
function picture(w, h) {
  renderer.setPixelRatio(1);
  renderer.setSize(w, h, false);
  camera.aspect = w / h;
  camera.clearViewOffset();
  camera.updateProjectionMatrix();
  controls.update();
  renderer.render(scene, camera);
  return renderer.domElement.toDataURL('image/png');
}
/// Moves the camera, without turning it, so that what is shown fills a picture.
function frameShown(aspect) {
  const direction = camera.position.clone().sub(controls.target).normalize(), box = new THREE.Box3();
  const right = up.clone().cross(direction).normalize(), above = direction.clone().cross(right);
  const boxes = model.parts.filter(isShown).map(p => new THREE.Box3().setFromObject(p.group));
  boxes.forEach(b => box.union(b));
  const middle = box.getCenter(new THREE.Vector3()), half = Math.tan(camera.fov * Math.PI / 360);
  let away = 0;
  for (const b of boxes) {
    for (let i = 0; i < 8; ++i) {
      const v = new THREE.Vector3(...['x', 'y', 'z'].map((c, k) => (i >> k & 1 ? b.max : b.min)[c])).sub(middle);
      away = Math.max(away, v.dot(direction) + 1.08 * Math.max(Math.abs(v.dot(above)), Math.abs(v.dot(right)) / aspect) / half);
    }
  }
  controls.target.copy(middle);
  camera.position.copy(middle).addScaledVector(direction, away);
}
function figure(name, text, uri) {
  const f = element('figure'), image = element('img');
  image.src = uri;
  f.append(element('b', name), image, element('p', text));
  return f;
}
function buildPrint() {
  const dark = document.documentElement.classList.contains('dark'), before = Object.assign({}, state);
  const eye = camera.position.clone(), target = controls.target.clone();
  document.documentElement.classList.remove('dark');
  Object.assign(state, {step: 0, explode: 0, selected: -1, ghost: false});
  const page = $('print'), grid = element('div', undefined, 'grid');
  page.textContent = '';
  page.append(element('h1', model.title), element('p', model.facts, 'facts'), grid);
  const width = 800, height = 500;
  for (let s = 0; s <= last; ++s) {
    state.step = s;
    if (s === 0) look(vec(model.view), false);
    else seeNewParts(false);
    slide = s > 1 ? 0.6 : 0;
    refresh();
    frameShown(width / height);
    const image = picture(width, height);
    grid.append(s === 0 ? figure('The finished model', '', image)
                        : figure(s + '  ' + ids(model.steps[s - 1].parts.slice(0, 1)), model.steps[s - 1].text, image));
  }
  slide = 0;
  document.documentElement.classList.toggle('dark', dark);
  Object.assign(state, before);
  camera.position.copy(eye);
  controls.target.copy(target);
  resize();
  controls.update();
  showStep();
  refresh();
}
async function printSteps() {
  buildPrint();
  await Promise.all([...$('print').querySelectorAll('img')].map(i => i.decode ? i.decode().catch(() => 0) : 0));
  window.print();
}
window.addEventListener('beforeprint', () => { if (!$('print').children.length) buildPrint(); });
