// The map reads without this script, by its marks and titles: it shows the pictures of the cell that is chosen, which is
// kept in the address behind #.
'use strict';
(() => {
  const data = JSON.parse(document.getElementById('stress-data').textContent);
  const panel = document.querySelector('.opened');
  const find = (name) => panel.querySelector(name);

  // One picture of a strip, as large as the frame.
  const show = (frame, setting, strip, subject) => {
    const place = setting.cells[subject]?.place ?? -1;
    frame.parentElement.hidden = place < 0;
    if (place < 0) return;
    const side = Math.max(setting.width, setting.height);
    const scale = 192 / side;
    frame.style.width = `${setting.width * scale}px`;
    frame.style.height = `${setting.height * scale}px`;
    frame.style.backgroundImage = `url(${strip})`;
    frame.style.backgroundSize = `${setting.width * scale}px auto`;
    frame.style.backgroundPosition = `0 ${-place * setting.height * scale}px`;
  };

  const entry = (list, name, value) => {
    const term = document.createElement('dt');
    const description = document.createElement('dd');
    term.textContent = name;
    description.textContent = value;
    list.append(term, description);
  };

  const open = (at, subject) => {
    const [a, s] = at.split('-').map(Number);
    const axis = data.axes[a];
    const setting = axis?.settings[s];
    const cell = setting?.cells[subject];
    if (!cell) return false;
    const base = axis.settings.find((other) => other.unstressed) ?? setting;
    find('h3').textContent = `${data.subjects[subject].label}, ${axis.label.toLowerCase()}: ${setting.label}`;
    find('.state').textContent = cell.state;
    find('.why').textContent = data.subjects[subject].limits[a] ?? '';
    const list = find('dl');
    list.replaceChildren();
    entry(list, 'error against own truth', cell.rmse);
    entry(list, 'unstressed', base.cells[subject]?.rmse ?? '–');
    entry(list, 'mean visibility', cell.mean);
    entry(list, 'run time', `${cell.time} ms (unstressed ${base.cells[subject]?.time ?? '–'} ms)`);
    entry(list, 'picture', `${setting.size}, ${setting.compared} pixels compared, ${setting.triangles} triangles`);
    show(find('.base-thumb'), base, base.visibility, subject);
    show(find('.stressed-thumb'), setting, setting.visibility, subject);
    show(find('.deviation-thumb'), setting, setting.deviation, subject);
    const what = axis.same_picture ? 'stressed − unstressed' : 'stressed − its truth';
    find('.deviation-text').textContent = `${what}, blue −${data.range} to red +${data.range}`;
    panel.hidden = false;
    document.querySelector('td.chosen')?.classList.remove('chosen');
    document.querySelector(`td[data-at="${at}"][data-of="${subject}"]`)?.classList.add('chosen');
    document.documentElement.dataset.opened = `${at} ${subject}`;
    return true;
  };

  const recall = () => {
    const [at, subject] = decodeURIComponent(location.hash.slice(1)).split('/');
    if (at && subject) open(at, subject);
  };
  document.querySelector('.map').addEventListener('click', (event) => {
    const cell = event.target.closest('td[data-at]');
    if (cell && open(cell.dataset.at, cell.dataset.of)) history.replaceState(null, '', `#${cell.dataset.at}/${cell.dataset.of}`);
  });
  addEventListener('hashchange', recall);
  recall();
  document.documentElement.dataset.ready = 'true';
})();
