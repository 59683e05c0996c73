// The first view, as the link asks for it.

if (window.matchMedia('(prefers-color-scheme: dark)').matches) document.documentElement.classList.add('dark');
$('title').textContent = model.title;
$('facts').textContent = model.facts;
$('step').max = last;
$('labels-button').classList.add('on');
$('textures-button').hidden = !hasTextures;
$('textures-button').classList.add('on');
if (!last) for (const id of ['step', 'play', 'back', 'next']) $(id).disabled = true;
controls.target.copy(centre);
camera.position.copy(centre).addScaledVector(vec(model.view), size);
resize();
look(vec(model.view), false);
// A link may say where to begin: assembly.html#step=7&explode=40&part=P03
const wishes = new URLSearchParams(location.hash.slice(1)), number = name => Number(wishes.get(name)) || 0;
if (wishes.has('dark')) document.documentElement.classList.add('dark');
setExplode(number('explode'));
setStep(number('step'), false);
if (wishes.has('part')) select(model.parts.findIndex(p => p.id === wishes.get('part')));
// For whoever drives the page by a program.
window.guide = {state, model, setStep, setExplode, select, buildPrint,
  shown: () => model.parts.filter(p => p.group.visible).map(p => p.id),
  position: id => model.parts.find(p => p.id === id).group.position.toArray(),
  moving: () => animations.size > 0,
  ready: () => model.parts.every(p => !p.image || p.image.image),
  picture: (w, h) => {
    const uri = picture(w, h);
    resize();
    return uri;
  }};
