// Tables that are wider than their place show the columns that fit, and a chooser for the others. Heads say by data-keep which
// columns stay longest: 0 stays always; without it, those on the right go first.
const usualKeep = 100;

// The heads over each column of a table, from the top: a cell that spans several columns or rows stands in all of them.
function headsOfColumns(rows) {
  const columns = [];
  [...rows].forEach((row, at) => {
    let column = 0;
    for (const head of row.cells) {
      while (columns[column]?.filled > at) column += 1;
      for (const end = column + head.colSpan; column < end; column += 1) {
        columns[column] ??= { heads: [] };
        columns[column].heads.push(head);
        columns[column].filled = at + head.rowSpan;
      }
    }
  });
  return columns.map(({ heads }) => heads);
}

function headName(head) {
  const words = head.querySelector('button') ?? head;
  return [...words.childNodes].map(({ textContent }) => textContent.trim()).filter(Boolean).join(' ');
}

class TableColumns {
  constructor(box, table) {
    this.box = box;
    this.table = table;
    this.over = headsOfColumns(table.tHead.rows);
    this.heads = this.over.map((heads) => heads.at(-1));
    this.shown = this.heads.map(() => true);
    this.chosen = false;  // by the reader, and no longer by what fits
    this.chooser = null;
  }

  // The first to go is the last here; the head of the rows and the column that sorts stay.
  get droppable() {
    const keep = ({ dataset }, i) => Number(dataset.keep ?? usualKeep + i);
    const rowHead = [...this.table.tBodies[0].rows[0]?.cells ?? []].findIndex(({ tagName }) => tagName === 'TH');
    const stays = (head, i) => i === rowHead || head.ariaSort || (i === 0 && !head.dataset.keep);
    return this.heads.map((head, i) => ({ i, keep: stays(head, i) ? 0 : keep(head, i) }))
      .filter((column) => column.keep > 0).sort((a, b) => a.keep - b.keep || a.i - b.i);
  }

  // Leaves out the last of these, and with it the columns under the same head that are kept as long.
  leaveOut(order) {
    const { i: last, keep } = order.at(-1);
    const together = (column) => column && column.keep === keep && this.over[column.i][0] === this.over[last][0];
    while (together(order.at(-1))) this.shown[order.pop().i] = false;
  }

  fit() {
    if (this.chosen) return;
    this.shown.fill(true);
    this.apply();
    const order = this.droppable;
    while (order.length > 0 && this.box.scrollWidth > this.box.clientWidth) {
      this.leaveOut(order);
      this.apply();
    }
    if (this.shown.includes(false) || this.chooser) this.showChooser();
  }

  // Cells that span several columns span those that are left.
  apply() {
    const spanLeft = (cell, columns) => {
      const left = columns.filter((column) => this.shown[column]).length;
      cell.hidden = left === 0;
      if (columns.length > 1) cell.colSpan = Math.max(left, 1);
    };
    for (const head of new Set(this.over.flat())) {
      spanLeft(head, this.over.flatMap((heads, column) => (heads.includes(head) ? [column] : [])));
    }
    for (const row of [...this.table.tBodies].flatMap(({ rows }) => [...rows])) {
      let column = 0;
      for (const cell of row.cells) {
        const span = Number(cell.dataset.span ??= cell.colSpan);
        spanLeft(cell, Array.from({ length: span }, (_, i) => column + i));
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
    const boxes = this.over.map((heads, i) => {
      const input = Object.assign(make('input'), { type: 'checkbox', checked: this.shown[i] });
      input.addEventListener('change', () => {
        this.chosen = true;
        this.shown[i] = input.checked || !this.shown.some((shown, other) => shown && other !== i);
        this.apply();
        this.showChooser();
      });
      return make('label', '', input, ` ${heads.map(headName).join(', ')}`);
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

// Captions are no wider than their place. Returns the columns of all tables.
function useColumns(section) {
  return [...section.querySelectorAll('.scroll')].flatMap((box) => {
    const table = box.querySelector('table.numbers');
    const columns = table?.tHead ? new TableColumns(box, table) : null;
    onWidth(box, () => {
      box.style.setProperty('--place', `${box.clientWidth}px`);
      columns?.fit();
    });
    return columns ?? [];
  });
}
