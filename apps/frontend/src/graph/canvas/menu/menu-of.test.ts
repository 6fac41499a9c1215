import { describe, expect, it } from 'vitest';
import { applyCommand } from '../../model/commands/apply-command.ts';
import { perform, startEditing, undo } from '../../model/commands/edit-state.ts';
import type { Graph } from '../../model/graph.ts';
import { aGraphOf, aModule, wiresIn } from '../../model/testing/small-graph.ts';
import type { MenuAction, MenuEntry, MenuPlace, MenuTarget } from './menu-entry.ts';
import { menuOf, nodesMeant } from './menu-of.ts';

const first = aModule('first', { in: 'double' }, { out: 'double' });
const second = aModule('second', { in: 'double', rest: 'double' }, { out: 'double' });
const chain = aGraphOf([first, second], {
  'first.in': '/a',
  'first.out': '/b',
  'second.in': '/b',
  'second.out': '/c',
});
const A = 'module:first';
const B = 'module:second';

function place(more: Partial<MenuPlace> = {}): MenuPlace {
  let count = 0;
  return {
    at: { x: 103, y: 58 },
    boxOf: (id) => ({ x: id === A ? 0 : 400, y: 0, width: 180, height: 80 }),
    spotOn: () => ({ x: 103, y: 58, leg: 0 }),
    uuid: () => `uuid-${(count += 1)}`,
    isTouch: false,
    ...more,
  };
}

const actions = (entries: readonly MenuEntry[]): MenuAction[] =>
  entries.flatMap((entry) => {
    if (entry.kind === 'separator') return [];
    return entry.kind === 'group' ? entry.entries : [entry];
  });
const texts = (graph: Graph, target: MenuTarget, more?: Partial<MenuPlace>): string[] =>
  actions(menuOf(graph, target, place(more))).map(({ text }) => text);
function chosen(graph: Graph, target: MenuTarget, text: string): MenuAction {
  const found = actions(menuOf(graph, target, place())).find((one) => one.text === text);
  if (found === undefined) throw new Error(`no entry ${text}`);
  return found;
}
function after(graph: Graph, target: MenuTarget, text: string): Graph {
  const { command } = chosen(graph, target, text);
  return command === undefined ? graph : applyCommand(graph, command).graph;
}

describe('the menu of a module', () => {
  const target = { kind: 'nodes', nodes: [A] } as const;

  it('shows only what applies', () => {
    const all = texts(chain, target);
    expect(all).toContain('Bypass');
    expect(all).toContain('Open module');
    expect(all).toContain('Delete and reconnect');
    expect(all).not.toContain('Left edges');
    expect(all).not.toContain('Select multiple');
    const alone = texts(aGraphOf([aModule('alone')]), { kind: 'nodes', nodes: ['module:alone'] });
    expect(alone).not.toContain('Disconnect all');
    expect(alone).not.toContain('Delete and reconnect');
  });

  it('offers fingers to select several', () => {
    expect(texts(chain, target, { isTouch: true })).toContain('Select multiple');
  });

  it('says what it would do next', () => {
    const muted = after(chain, target, 'Mute');
    expect(texts(muted, target)).toContain('Enable');
    const collapsed = after(chain, target, 'Collapse');
    expect(texts(collapsed, target)).toContain('Expand');
  });

  it('takes all wires off, or leads them past', () => {
    expect(wiresIn(after(chain, target, 'Disconnect all'))).toEqual(['second.out > topic:/c']);
    expect(wiresIn(after(chain, target, 'Delete and reconnect'))).toContain('topic:/a > second.in');
  });
});

it('is about all that is selected when it is asked for on one of them', () => {
  expect(nodesMeant(new Set([A, B]), A)).toEqual([A, B]);
  expect(nodesMeant(new Set([B]), A)).toEqual([A]);
  const all = texts(chain, { kind: 'nodes', nodes: [A, B] });
  expect(all).toContain('Left edges');
  expect(all).not.toContain('Distribute horizontally');
  expect(all).not.toContain('Open module');
  const framed = after(chain, { kind: 'nodes', nodes: [A, B] }, 'Add frame');
  expect(framed.nodes.get(A)?.frame).toMatch(/^frame:/);
});

describe('the menu of a wire', () => {
  const wire = [...chain.wires.values()].find(({ via }) => via === '/b')!.id;
  const target = { kind: 'wire', wire } as const;

  it('leads it through the place that was pointed at', () => {
    const led = after(chain, target, 'Add bend point');
    expect(led.wires.get(wire)?.points).toEqual([{ x: 100, y: 60 }]);
    expect(after(led, target, 'Remove bend points').wires.get(wire)?.points).toEqual([]);
  });

  it('shows its topic, and deletes it', () => {
    expect(after(chain, target, 'Show topic as node').nodes.has('topic:/b')).toBe(true);
    expect(after(chain, target, 'Delete').wires.has(wire)).toBe(false);
    expect(chosen(chain, target, 'Insert module…').request).toMatchObject({ wire });
  });
});

describe('the menu of a socket', () => {
  it('sets a value where nothing is wired, and takes wires off', () => {
    const rest = { kind: 'socket', port: { node: B, port: 'in:rest' } } as const;
    const set = after(chain, rest, 'Set value');
    expect(set.nodes.get(B)).toMatchObject({ constants: new Map([['rest', '{"double":0}']]) });
    expect(texts(set, rest)).toContain('Use default');
    const wired = { kind: 'socket', port: { node: B, port: 'in:in' } } as const;
    expect(texts(chain, wired)).toEqual(['Connect from…', 'Disconnect']);
    expect(wiresIn(after(chain, wired, 'Disconnect'))).not.toContain('first.out > second.in (/b)');
  });
});

describe('the menu of the canvas', () => {
  it('adds where it was asked for', () => {
    const target = { kind: 'canvas' } as const;
    expect(chosen(chain, target, 'Add node…').request).toEqual({
      kind: 'add',
      at: { x: 103, y: 58 },
    });
    const noted = after(chain, target, 'Add note');
    expect([...noted.nodes.values()].at(-1)).toMatchObject({
      kind: 'comment',
      position: { x: 100, y: 60 },
    });
    expect(texts(aGraphOf([]), target)).toEqual(['Add node…', 'Add note', 'Paste']);
  });
});

it('every command of every menu is one step that undo takes back', () => {
  const targets: MenuTarget[] = [
    { kind: 'canvas' },
    { kind: 'nodes', nodes: [A] },
    { kind: 'nodes', nodes: [A, B, 'topic:/a'] },
    { kind: 'nodes', nodes: ['topic:/a'] },
    ...[...chain.wires.keys()].map((wire) => ({ kind: 'wire', wire }) as const),
    { kind: 'socket', port: { node: B, port: 'in:rest' } },
    { kind: 'socket', port: { node: A, port: 'out:out' } },
  ];
  for (const target of targets) {
    for (const { command, text } of actions(menuOf(chain, target, place()))) {
      if (command === undefined) continue;
      const done = perform(startEditing(chain), command);
      expect(done.past.length, text).toBeLessThanOrEqual(1);
      expect(undo(done).graph, text).toEqual(chain);
    }
  }
});

it('is empty for what is gone', () => {
  expect(menuOf(chain, { kind: 'nodes', nodes: ['module:x'] }, place())).toEqual([]);
  expect(menuOf(chain, { kind: 'wire', wire: 'x' }, place())).toEqual([]);
  expect(menuOf(chain, { kind: 'socket', port: { node: 'x', port: 'y' } }, place())).toEqual([]);
});
