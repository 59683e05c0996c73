// What is shown of the model in a state, in which colours and where.

const isShown = part => state.step === 0 || (part.step >= 0 && part.step < state.step);
const isNew = part => state.step > 0 && part.step === state.step - 1;
const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

let slide = 0;  // how far the new parts still are from their places, 0..1
const slideLength = step => (model.parts[step.parts[0]].kind === 'panel' ? 0.28 : 0.1) * size;

function paint(part, i, theme) {
  const selected = i === state.selected, fresh = isNew(part), pale = state.step > 0 && !fresh && !selected;
  const base = new THREE.Color(part.colour), cut = base.clone().multiplyScalar(0.75);
  if (pale) {
    base.lerp(theme.pale, 0.78);
    cut.lerp(theme.pale, 0.6);
  }
  const pictured = part.image && part.image.image && state.textures;
  const [face, rest] = part.mesh.material;
  face.map = pictured ? part.image : null;
  face.color.copy(pictured ? new THREE.Color(pale ? 0xd8d8d8 : 0xffffff) : base);
  rest.color.copy(cut);
  const ghost = state.ghost && state.step > 0 && !fresh && part.kind === 'panel' && !selected;
  for (const material of part.mesh.material) {
    material.emissive.copy(selected ? theme.accent : theme.none).multiplyScalar(selected ? 0.35 : 0);
    material.transparent = ghost;
    material.opacity = ghost ? 0.22 : 1;
    material.depthWrite = !ghost;
    material.needsUpdate = true;
  }
  part.lines.material.color.copy(selected ? theme.accent : pale ? theme.paleInk : theme.ink);
}

function place(part) {
  part.group.position.copy(part.explosion).multiplyScalar(state.explode / 100);
  if (isNew(part) && slide > 0) {
    const step = model.steps[part.step];
    part.group.position.addScaledVector(vec(step.direction), -slide * slideLength(step));
  }
  part.group.visible = isShown(part);
}

function placeArrow(theme) {
  arrow.visible = state.step > 1;
  if (!arrow.visible) return;
  const step = model.steps[state.step - 1], first = model.parts[step.parts[0]], d = vec(step.direction);
  const length = slideLength(step), r = size * 0.0045;
  for (const m of [arrowShaft.material, arrowHead.material]) m.color.copy(theme.accent);
  arrow.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), d);
  arrow.position.copy(first.middle).addScaledVector(first.explosion, state.explode / 100)
      .addScaledVector(d, -0.03 * size);
  const head = Math.min(9 * r, length / 2);
  arrowHead.scale.set(3 * r, head, 3 * r);
  arrowHead.position.set(0, -head / 2, 0);
  arrowShaft.scale.set(r, length - head, r);
  arrowShaft.position.set(0, -head - (length - head) / 2, 0);
}

function refresh() {
  const dark = document.documentElement.classList.contains('dark');
  const theme = {
    accent: new THREE.Color(colour('--accent')), none: new THREE.Color(0),
    ink: new THREE.Color(dark ? 0x0b0c0e : 0x26241f), pale: new THREE.Color(dark ? 0x4a4f58 : 0xefece5),
    paleInk: new THREE.Color(dark ? 0x1b1d21 : 0xb3aea3)
  };
  model.parts.forEach((part, i) => {
    place(part);
    paint(part, i, theme);
  });
  placeArrow(theme);
  draw();
}
