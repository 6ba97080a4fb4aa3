// What report.html is made of beside its data: how it looks, and what it does.
#pragma once

namespace ssrkit {

inline constexpr const char* kChecksStyle = R"(
body { font: 15px/1.45 system-ui, sans-serif; margin: 1.5rem auto; max-width: 90rem; padding: 0 1rem; color: #1a1a1a; }
h1 { margin: 0 0 .3rem; font-size: 1.6rem; } h2 { margin: 2rem 0 .5rem; font-size: 1.2rem; }
code, pre, td, th { font-family: ui-monospace, monospace; font-size: .82rem; }
pre { background: #f4f4f4; padding: .6rem; margin: .3rem 0; overflow-x: auto; white-space: pre-wrap; }
table { border-collapse: collapse; } th { text-align: left; vertical-align: bottom; }
td, th { padding: .15rem .7rem .15rem 0; vertical-align: top; }
.number { text-align: right; } .quiet { color: #555; }
.scroll { overflow-x: auto; }
.badge, .matrix td.cell { padding: .1rem .5rem; border-radius: .3rem; color: #000; background: #d9d9d9; }
.matrix { border-spacing: 3px; border-collapse: separate; } .matrix td.cell { text-align: center; cursor: pointer; }
.pass { background: #8fd9c0 !important; } .warn, .xfail, .flake, .inconclusive { background: #f0e442 !important; }
.fail, .error, .crash, .timeout, .limiter, .missing, .xpass { background: #f3a97f !important; }
.skip { background: #d9d9d9 !important; }
#filters { position: sticky; top: 0; background: #fff; padding: .5rem 0; display: flex; flex-wrap: wrap; gap: .6rem; }
#filters label { display: flex; flex-direction: column; font-size: .78rem; color: #555; }
select, input, button { font: inherit; padding: .15rem .3rem; max-width: 20rem; }
#checks { width: 100%; } #checks tbody tr.check { cursor: pointer; border-top: 1px solid #e4e4e4; }
#checks tbody tr.check:hover, #checks tbody tr.check:focus { background: #f2f7fb; }
img { image-rendering: pixelated; width: 320px; border: 1px solid #999; display: block; margin: .3rem 0; }
)";

// Every text goes in by textContent, so that nothing in the data can become markup.
inline constexpr const char* kChecksScript = R"(
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const at = Object.fromEntries(data.columns.map((name, i) => [name, i]));
const text = (row, column) => data.strings[row[at[column]]];
const by = id => document.getElementById(id);
const severity = new Map(data.outcomes.map((name, i) => [name, i]));
const failing = new Set(data.failures);
const kPage = 200;
let shown = kPage;
let found = [];

function element(tag, className, content) {
  const node = document.createElement(tag);
  if (className) node.className = className;
  if (content !== undefined) node.textContent = content;
  return node;
}

function optionsFor(select, values) {
  for (const value of values) {
    const option = element('option', '', value === '' ? '(none)' : value);
    option.value = '=' + value;
    select.append(option);
  }
}

function uniqueOf(column) {
  return [...new Set(data.rows.map(row => row[at[column]]))].map(i => data.strings[i]).sort((a, b) => a.localeCompare(b, 'en', {numeric: true}));
}

function matches(row) {
  const outcome = by('outcome').value;
  if (outcome === 'failures' && !failing.has(text(row, 'outcome'))) return false;
  if (outcome.startsWith('=') && outcome.slice(1) !== text(row, 'outcome')) return false;
  for (const column of ['device', 'id', 'scene']) {
    const wanted = by(column).value;
    if (wanted && wanted.slice(1) !== text(row, column)) return false;
  }
  const words = by('search').value.toLowerCase().split(' ').filter(word => word);
  if (!words.length) return true;
  const all = data.columns.map(column => column === 'picture' ? '' : text(row, column)).join(' ').toLowerCase();
  return words.every(word => all.includes(word));
}

function details(row) {
  const line = element('tr', 'details');
  const cell = element('td');
  cell.colSpan = 8;
  const picture = text(row, 'picture');
  if (picture) {
    const image = element('img');
    image.src = 'data:image/png;base64,' + picture;
    image.alt = 'Where the texels are that differ: the brighter, the worse';
    image.title = image.alt;
    cell.append(image);
  }
  cell.append(element('pre', '', text(row, 'message') || 'no message'));
  const repro = text(row, 'repro');
  if (repro && !text(row, 'message').includes(repro)) cell.append(element('pre', '', repro));
  line.append(cell);
  return line;
}

function toggle(line, row) {
  if (line.nextSibling && line.nextSibling.className === 'details') line.nextSibling.remove();
  else line.after(details(row));
}

function lineOf(row) {
  const line = element('tr', 'check');
  line.tabIndex = 0;
  const outcome = element('td');
  outcome.append(element('span', 'badge ' + text(row, 'outcome'), text(row, 'outcome')));
  line.append(outcome);
  for (const column of ['id', 'scene', 'size', 'case', 'stage', 'device'])
    line.append(element('td', '', text(row, column)));
  const bound = text(row, 'bound');
  line.append(element('td', '', text(row, 'value') + (bound ? ' (' + bound + ')' : '')));
  line.addEventListener('click', () => toggle(line, row));
  line.addEventListener('keydown', event => { if (event.key === 'Enter') toggle(line, row); });
  return line;
}

function draw() {
  by('rows').replaceChildren(...found.slice(0, shown).map(lineOf));
  by('count').textContent = found.length + ' of ' + data.rows.length + ' checks' +
    (found.length > shown ? ', the first ' + shown + ' are shown' : '');
  by('more').hidden = found.length <= shown;
}

function filter() {
  shown = kPage;
  found = data.rows.filter(matches);
  draw();
}

function show(id, device) {
  by('outcome').value = '';
  by('search').value = '';
  by('scene').value = '';
  by('id').value = '=' + id;
  by('device').value = '=' + device;
  filter();
  by('filters').scrollIntoView();
}

function drawMatrix(ids, devices) {
  const cells = new Map();
  for (const row of data.rows) {
    const key = row[at.id] + ' ' + row[at.device];
    const outcome = text(row, 'outcome');
    const cell = cells.get(key) || {all: 0, failed: 0, worst: outcome};
    cell.all += 1;
    cell.failed += failing.has(outcome) ? 1 : 0;
    if (severity.get(outcome) > severity.get(cell.worst)) cell.worst = outcome;
    cells.set(key, cell);
  }
  const number = new Map(data.strings.map((string, i) => [string, i]));
  const head = element('tr');
  head.append(element('th', '', 'check'), ...devices.map(device => element('th', '', device || '(none)')));
  by('matrix').append(head);
  const broken = new Set(data.rows.filter(row => failing.has(text(row, 'outcome'))).map(row => text(row, 'id')));
  for (const id of [...ids.filter(id => broken.has(id)), ...ids.filter(id => !broken.has(id))]) {
    const line = element('tr');
    line.append(element('td', '', id));
    for (const device of devices) {
      const cell = cells.get(number.get(id) + ' ' + number.get(device));
      if (!cell) { line.append(element('td')); continue; }
      const node = element('td', 'cell ' + cell.worst, cell.failed ? cell.failed + ' of ' + cell.all : cell.all);
      node.title = id + ' on ' + device + ': ' + cell.all + ' checks, ' + cell.failed + ' failed, worst ' + cell.worst;
      node.addEventListener('click', () => show(id, device));
      line.append(node);
    }
    by('matrix').append(line);
  }
}

data.rows.sort((a, b) => severity.get(text(b, 'outcome')) - severity.get(text(a, 'outcome')));
const ids = uniqueOf('id');
const devices = uniqueOf('device');
optionsFor(by('outcome'), data.outcomes.filter(name => data.rows.some(row => text(row, 'outcome') === name)));
optionsFor(by('device'), devices);
optionsFor(by('id'), ids);
optionsFor(by('scene'), uniqueOf('scene'));
if (data.rows.some(row => failing.has(text(row, 'outcome')))) by('outcome').value = 'failures';
for (const name of ['outcome', 'device', 'id', 'scene']) by(name).addEventListener('change', filter);
by('search').addEventListener('input', filter);
by('more').addEventListener('click', () => { shown += kPage; draw(); });
drawMatrix(ids, devices);
filter();
)";

}  // namespace ssrkit
