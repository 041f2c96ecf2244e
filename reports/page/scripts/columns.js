// Tables that are wider than their place show the columns that fit, and a chooser for the others. Heads say by data-keep which
// columns stay longest: 0 stays always; without it, those on the right go first.
const usualKeep = 100;

class TableColumns {
  constructor(box, table) {
    this.box = box;
    this.table = table;
    this.heads = [...table.tHead.rows[0].cells];
    this.shown = this.heads.map(() => true);
    this.chosen = false;  // by the reader, and no longer by what fits
    this.chooser = null;
  }

  // The first to go is the last here; the head of the rows and the column that sorts stay.
  get droppable() {
    const keep = ({ dataset }, i) => Number(dataset.keep ?? usualKeep + i);
    const rowHead = [...this.table.tBodies[0].rows[0]?.cells ?? []].findIndex(({ tagName }) => tagName === 'TH');
    return this.heads.map((head, i) => ({ i, keep: i === 0 || i === rowHead || head.ariaSort ? 0 : keep(head, i) }))
      .filter((column) => column.keep > 0).sort((a, b) => a.keep - b.keep || a.i - b.i).map(({ i }) => i);
  }

  fit() {
    if (this.chosen) return;
    this.shown.fill(true);
    this.apply();
    const order = this.droppable;
    while (order.length > 0 && this.box.scrollWidth > this.box.clientWidth) {
      this.shown[order.pop()] = false;
      this.apply();
    }
    if (this.shown.includes(false) || this.chooser) this.showChooser();
  }

  // Cells that span several columns span those that are left.
  apply() {
    for (const row of this.table.rows) {
      let column = 0;
      for (const cell of row.cells) {
        const span = Number(cell.dataset.span ??= cell.colSpan);
        const left = this.shown.slice(column, column + span).filter(Boolean).length;
        cell.hidden = left === 0;
        if (span > 1) cell.colSpan = Math.max(left, 1);
        column += span;
      }
    }
  }

  showChooser() {
    if (!this.chooser) {
      this.chooser = make('details', 'columns', make('summary', ''));
      this.chooser.addEventListener('toggle', () => this.fillChooser(), { once: true });
      this.box.before(this.chooser);
    }
    const count = this.shown.filter(Boolean).length;
    this.chooser.querySelector('summary').textContent = `Columns: ${count} of ${this.heads.length}`;
    this.chooser.querySelectorAll('input').forEach((input, i) => { input.checked = this.shown[i]; });
  }

  fillChooser() {
    const boxes = this.heads.map((head, i) => {
      const input = Object.assign(make('input'), { type: 'checkbox', checked: this.shown[i] });
      input.addEventListener('change', () => {
        this.chosen = true;
        this.shown[i] = input.checked || !this.shown.some((shown, other) => shown && other !== i);
        this.apply();
        this.showChooser();
      });
      return make('label', '', input, ` ${[...head.querySelectorAll('button')].concat(head)[0].innerText.replace(/\s+/g, ' ').trim() || head.textContent.trim()}`);
    });
    this.chooser.append(make('fieldset', '', make('legend', 'visually-hidden', 'Columns of the table'), ...boxes));
  }
}

// Calls `act` now and whenever the box has another width, unless that is 0.
function onWidth(box, act) {
  let width = 0;
  const look = () => {
    if (box.clientWidth === width || box.clientWidth === 0) return;
    width = box.clientWidth;
    act();
  };
  look();
  new ResizeObserver(() => requestAnimationFrame(look)).observe(box);
}

// Captions are no wider than their place. Columns are left out of tables whose heads lie in one row, each over one column.
function useColumns(section) {
  for (const box of section.querySelectorAll('.scroll')) {
    const table = box.querySelector('table.numbers');
    const rows = table?.tHead?.rows;
    const simple = rows?.length === 1 && [...rows[0].cells].every(({ colSpan }) => colSpan === 1);
    const columns = simple ? new TableColumns(box, table) : null;
    onWidth(box, () => {
      box.style.setProperty('--place', `${box.clientWidth}px`);
      columns?.fit();
    });
  }
}
