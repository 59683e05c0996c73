// The card of a part: its id, its neighbours, its place on the sheets.

function chip(i, note) {
  const b = element('button', model.parts[i].id);
  if (note) b.append(element('small', note));
  b.addEventListener('click', () => select(i));
  return b;
}
function section(title, chips) {
  const div = element('div', undefined, 'chips');
  div.append(...chips);
  return chips.length ? [element('h3', title), div] : [];
}
function select(i, clicked) {
  state.selected = i;
  const card = $('card');
  card.hidden = i < 0;
  card.textContent = '';
  if (i >= 0) {
    const part = model.parts[i];
    if (state.step > 0 && !isShown(part)) setStep(part.step + 1, false);
    else if (part.kind === 'panel' && !clicked) see(part.normal, true);
    const head = element('h2'), swatch = element('em'), close = element('button', '×');
    swatch.style.background = part.colour;
    close.title = 'Let go (Esc)';
    close.addEventListener('click', () => select(-1));
    head.append(swatch, document.createTextNode(part.id), close);
    const facts = [part.kind === 'panel' ? 'Panel' : 'Connector', `${part.extent[0]} × ${part.extent[1]} mm`];
    if (part.sheet >= 0) facts.push('sheet ' + (part.sheet + 1));
    if (part.step >= 0) facts.push('step ' + (part.step + 1));
    card.append(head, element('p', facts.join(' · ')));
    card.append(...(part.kind === 'panel' ? panelSections(part) : connectorSections(part)));
    if (part.step >= 0) {
      const go = element('button', 'Show its step');
      go.addEventListener('click', () => setStep(part.step + 1, true));
      card.append(element('h3', 'Assembly'), go);
    }
    if (part.sheet >= 0) card.append(element('h3', model.sheets[part.sheet].file), sheetMap(i));
  }
  refresh();
}
function panelSections(part) {
  const panel = model.panels[part.panel];
  const across = panel.neighbours.filter(n => model.panels[n.panel].parts.length)
      .map(n => chip(model.panels[n.panel].parts[0], n.joint === 'none' ? 'glue' : n.joint === 'teeth' ? 'teeth' : n.connectors.length + '×'));
  const connectors = [].concat(...panel.neighbours.map(n => n.connectors)).map(c => chip(c));
  const pieces = panel.parts.filter(i => model.parts[i] !== part).map(i => chip(i));
  return [...section('Neighbours', across), ...section('Connectors', connectors), ...section('Other pieces of ' + panel.id, pieces)];
}
function connectorSections(part) {
  return section('Joins', part.ends.filter(p => model.panels[p].parts.length).map(p => chip(model.panels[p].parts[0])));
}
/// Where the part lies on its sheet.
function sheetMap(chosen) {
  const sheet = model.sheets[model.parts[chosen].sheet], ns = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(ns, 'svg');
  svg.setAttribute('viewBox', `0 0 ${sheet.width} ${sheet.height}`);
  svg.setAttribute('role', 'img');
  for (const placement of sheet.placements) {
    const part = model.parts[placement.part], a = placement.rotation * Math.PI / 180, d = [];
    for (let k = 0; k < part.outline.length; k += 2) {
      const x = placement.mirrored ? -part.outline[k] : part.outline[k], y = part.outline[k + 1];
      d.push((Math.cos(a) * x - Math.sin(a) * y + placement.x).toFixed(1) + ' ' +
             (sheet.height - (Math.sin(a) * x + Math.cos(a) * y + placement.y)).toFixed(1));
    }
    const path = document.createElementNS(ns, 'path');
    path.setAttribute('d', 'M' + d.join('L') + 'Z');
    path.setAttribute('fill', placement.part === chosen ? '#d2521a' : '#e9e6df');
    path.setAttribute('stroke', placement.part === chosen ? '#7a2c0a' : '#b9b4a8');
    path.setAttribute('stroke-width', sheet.width / 400);
    path.style.cursor = 'pointer';
    path.addEventListener('click', () => select(placement.part));
    const title = document.createElementNS(ns, 'title');
    title.textContent = part.id;
    path.appendChild(title);
    svg.appendChild(path);
  }
  return svg;
}
