import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { applyCommand } from '../commands/apply-command.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import { graphOf } from '../graph-of.ts';
import type { Graph } from '../graph.ts';
import { commentNode } from '../make-node.ts';
import { searchGraph } from '../search-graph.ts';
import { sessionOf } from '../session-of.ts';
import { arbitrarySession } from '../testing/arbitrary-session.ts';
import { numbersOf, randomCommand } from '../testing/random-command.ts';
import { aGraphOf, aModule, aSessionOf, ref, wiresIn } from '../testing/small-graph.ts';
import { withIds } from '../with-ids.ts';
import { changesBetween } from './changes-between.ts';
import {
  draftIds,
  draftText,
  findDraft,
  newDraftNames,
  parseDraft,
  removeDraft,
  saveDraft,
} from './draft.ts';
import { keepEditorData } from './keep-editor-data.ts';
import { mergeGraphs } from './merge-graphs.ts';

/** Many graphs take long on a busy computer. */
const TIMEOUT_MS = 60_000;
const modules = [
  aModule('a', { i: 'double' }, { o: 'double' }),
  aModule('b', { i: 'double', j: 'double' }, { o: 'double' }),
];
const session = aSessionOf(modules, { 'a.i': '/in', 'a.o': '/ab', 'b.i': '/ab' });
const graph = graphOf(session);
const after = (start: Graph, ...commands: GraphCommand[]): Graph =>
  commands.reduce((one, command) => applyCommand(one, command).graph, start);
const hertz = (hertz: number): GraphCommand => ({
  kind: 'setModule',
  node: 'module:b',
  changes: { processingMode: { frequency: { hertz } } },
});
const constant = (json: string): GraphCommand => ({
  kind: 'setConstant',
  node: 'module:b',
  input: 'j',
  json,
});
const remove = (node: string): GraphCommand => ({ kind: 'remove', nodes: [node] });

describe('changes of a running session [SE-15]', () => {
  const words = (...commands: GraphCommand[]): string[] =>
    changesBetween(session, sessionOf(after(graph, ...commands), session)).map(
      ({ effect, words }) => `${effect}: ${words}`,
    );

  it('are none when nothing changed', () => {
    expect(changesBetween(session, session)).toEqual([]);
  });

  it('of mappings, values and modes apply at once', () => {
    expect(words(hertz(60), constant('{"double":1}'))).toEqual([
      'live: b runs 60 Hz.',
      'live: b · j is connected to the constant {"double":1}.',
    ]);
    expect(words(remove('topic:/in'))).toEqual(['live: a · i is connected to nothing.']);
    const positions = new Map([['module:a', { x: 1, y: 2 }]]);
    expect(words({ kind: 'move', positions })).toEqual(['none: Layout changed.']);
  });

  it('of code, inputs and places restart the module', () => {
    const change = (changes: object): string[] =>
      words({ kind: 'setModule', node: 'module:a', changes });
    expect(change({ onProcessingStringified: '() => 1' })).toEqual([
      'restart: a restarts: its code changed.',
    ]);
    expect(change({ outputs: [] })).toEqual(['restart: a restarts: its outputs changed.']);
    expect(change({ nodeId: 'lab' })).toEqual(['restart: a restarts: it moves to another node.']);
    expect(change({ description: 'Better' })).toEqual(['none: The details of a change.']);
  });

  it('start and end modules', () => {
    const changes = changesBetween(session, sessionOf(after(graph, remove('module:b')), session));
    expect(changes.map(({ effect }) => effect).sort()).toEqual(['end', 'live']);
    expect(changesBetween(aSessionOf([]), session).map(({ words }) => words)).toEqual([
      'a starts.',
      'b starts.',
    ]);
  });

  it('do not name what the master says', () => {
    const [first, ...rest] = session.processingModules;
    const extension = {
      version: '',
      libraries: [],
      assets: [],
      optionalAssets: [],
      replaceable: true,
      origin: 0 as const,
      grantIds: [],
    };
    const placed = { ...first!, nodeId: 'master', status: 2 as const, sessionId: 'x', extension };
    expect(changesBetween({ ...session, processingModules: [placed, ...rest] }, session)).toEqual(
      [],
    );
  });
});

describe('a change of another user', () => {
  it('is there beside mine', () => {
    const mine = after(graph, hertz(60), { kind: 'setDetails', changes: { name: 'Mine' } });
    const theirs = after(graph, constant('{"double":1}'), {
      kind: 'add',
      nodes: [commentNode('comment:1', 'Hello')],
    });
    const { graph: merged, conflicts } = mergeGraphs(graph, mine, theirs);
    expect(conflicts).toEqual([]);
    expect(merged.nodes.get('module:b')).toMatchObject({
      module: { processingMode: { frequency: { hertz: 60 } } },
      constants: new Map([['j', '{"double":1}']]),
    });
    expect(merged.nodes.has('comment:1')).toBe(true);
    expect(merged.details.name).toBe('Mine');
  });

  it('shares what I did not touch', () => {
    const theirs = graphOf(sessionOf(after(graph, constant('{"double":1}')), session));
    const { graph: merged } = mergeGraphs(graph, after(graph, remove('topic:/in')), theirs);
    expect(merged.nodes.get('module:b')).toBe(theirs.nodes.get('module:b'));
    expect(mergeGraphs(graph, graph, theirs).graph.nodes).toEqual(theirs.nodes);
  });

  it('that lost the editor data gets it back [EX-22]', () => {
    const positions = new Map([['module:a', { x: 1, y: 2 }]]);
    const before = sessionOf(after(graph, { kind: 'move', positions }), session);
    const name = 'By an old client';
    const kept = keepEditorData({ ...before, name, extension: undefined }, before);
    expect(graphOf(kept).nodes.get('module:a')?.position).toEqual({ x: 1, y: 2 });
    expect(kept.name).toBe(name);
    expect(keepEditorData(before, session)).toBe(before);
    expect(keepEditorData(session, before).extension?.editorJson).not.toBe('');
  });

  it('of the same thing is a conflict that keeps both', () => {
    const { graph: merged, conflicts } = mergeGraphs(
      graph,
      after(graph, hertz(60)),
      after(graph, hertz(90)),
    );
    expect(conflicts).toMatchObject([
      {
        what: 'The mode of b',
        mine: { frequency: { hertz: 60 } },
        theirs: { frequency: { hertz: 90 } },
      },
    ]);
    const theirWay = after(merged, conflicts[0]!.takeTheirs);
    expect(theirWay).toEqual(after(graph, hertz(90)));
  });

  it('of what I removed brings it back and asks', () => {
    const { graph: merged, conflicts } = mergeGraphs(
      graph,
      after(graph, remove('module:b')),
      after(graph, hertz(90)),
    );
    expect(merged.nodes.has('module:b')).toBe(true);
    expect(conflicts.map(({ what }) => what)).toEqual([
      'b, which you deleted and another client changed',
    ]);
    expect(after(merged, conflicts[0]!.takeTheirs)).toBe(merged);
    expect(after(merged, conflicts[0]!.takeMine!).nodes.has('module:b')).toBe(false);
  });

  it('that removes what I changed or wired leaves it and asks', () => {
    const theirs = after(graph, remove('module:b'));
    const wired = after(graph, { kind: 'connect', from: ref(graph, 'b.o'), to: ref(graph, 'a.i') });
    for (const mine of [after(graph, hertz(60)), wired]) {
      const { graph: merged, conflicts } = mergeGraphs(graph, mine, theirs);
      expect(merged.nodes.has('module:b')).toBe(true);
      expect(conflicts.map(({ what }) => what)).toEqual(['b, which another client deleted']);
      expect(after(merged, conflicts[0]!.takeTheirs).nodes.has('module:b')).toBe(false);
    }
  });

  it('that wires an input I wired too leaves mine and offers theirs', () => {
    const start = aGraphOf(modules);
    const to = ref(start, 'b.i');
    const mine = after(start, { kind: 'connect', from: ref(start, 'a.o'), to });
    const theirs = after(start, { kind: 'connect', from: ref(start, 'b.o'), to });
    const { graph: merged, conflicts } = mergeGraphs(start, mine, theirs);
    expect(wiresIn(merged)).toEqual(['a.o > b.i (/Test/a/o)']);
    expect(conflicts).toMatchObject([{ what: 'Source of b · i', mine: 'a · o', theirs: 'b · o' }]);
    expect(wiresIn(after(merged, conflicts[0]!.takeTheirs))).toEqual(['b.o > b.i (/Test/b/o)']);
  });

  it(
    'is all there when I did nothing, and mine when they did nothing',
    () => {
      fc.assert(
        fc.property(arbitrarySession, fc.array(fc.nat(60), { minLength: 1 }), (loose, list) => {
          let count = 0;
          const base = graphOf(withIds(loose, () => `id${(count += 1)}`));
          const next = numbersOf(list);
          let changed = base;
          for (let i = 0; i < 8; i += 1) {
            changed = applyCommand(changed, randomCommand(changed, next)).graph;
          }
          const taken = mergeGraphs(base, base, changed);
          expect(taken.graph.wires).toEqual(changed.wires);
          expect(new Set(taken.graph.nodes.keys())).toEqual(new Set(changed.nodes.keys()));
          expect(taken.conflicts).toEqual([]);
          const kept = mergeGraphs(base, changed, base);
          expect(kept.graph.wires).toEqual(changed.wires);
          expect(new Set(kept.graph.nodes.keys())).toEqual(new Set(changed.nodes.keys()));
          expect(kept.conflicts).toEqual([]);
        }),
      );
    },
    TIMEOUT_MS,
  );

  it(
    'merges into a graph that its session gives again, whatever both did',
    () => {
      const numbers = fc.array(fc.nat(60), { minLength: 1, maxLength: 40 });
      fc.assert(
        fc.property(arbitrarySession, numbers, numbers, (loose, myList, theirList) => {
          let count = 0;
          const start = withIds(loose, () => `id${(count += 1)}`);
          const base = graphOf(start);
          const edited = (list: readonly number[]): Graph => {
            const next = numbersOf(list);
            let one = base;
            for (let i = 0; i < 6; i += 1) one = applyCommand(one, randomCommand(one, next)).graph;
            return one;
          };
          const theirs = edited(theirList);
          const { graph: merged, conflicts } = mergeGraphs(base, edited(myList), theirs);
          const theirSession = sessionOf(theirs, start);
          const saved = sessionOf(merged, theirSession);
          const again = graphOf(saved);
          expect(wiresIn(again)).toEqual(wiresIn(merged));
          expect(new Set(again.nodes.keys())).toEqual(new Set(merged.nodes.keys()));
          for (const { takeTheirs, what } of conflicts) {
            expect(what).not.toBe('');
            applyCommand(merged, takeTheirs);
          }
        }),
      );
    },
    TIMEOUT_MS,
  );
});

describe('drafts', () => {
  const storage = (limit = Infinity): Storage => {
    const items = new Map<string, string>();
    return {
      get length() {
        return items.size;
      },
      key: (index) => [...items.keys()][index] ?? null,
      getItem: (key) => items.get(key) ?? null,
      setItem: (key, value) => {
        if (value.length > limit) throw new DOMException('full', 'QuotaExceededError');
        items.set(key, value);
      },
      removeItem: (key) => void items.delete(key),
      clear: () => items.clear(),
    };
  };
  const draft = {
    sessionId: 'session',
    revision: 3,
    base: session,
    edited: sessionOf(after(graph, hertz(60)), session),
    savedMs: 1000,
  };

  it('come back as they were', () => {
    const items = storage();
    expect(saveDraft(items, draft)).toBe(true);
    expect(saveDraft(items, { ...draft, sessionId: 'other', savedMs: 2000 })).toBe(true);
    expect(findDraft(items, 'session')).toEqual(draft);
    expect([...draftIds(items)].sort()).toEqual(['other', 'session']);
    removeDraft(items, 'session');
    expect(findDraft(items, 'session')).toBeUndefined();
  });

  it('name the sessions that only they have', () => {
    const items = storage();
    saveDraft(items, draft);
    const edited = { ...session, name: 'Session' };
    saveDraft(items, { ...draft, sessionId: 'new', revision: 0, edited });
    expect(newDraftNames(items)).toEqual(['Session']);
  });

  it('say when there is no room, and that a text is none', () => {
    expect(saveDraft(storage(10), draft)).toBe(false);
    for (const text of ['', '{', 'null', '{"version":2}', '{"version":1}', '[]']) {
      expect(parseDraft(text)).toBeUndefined();
    }
    const broken = draftText(draft).replace('"edited":{', '"edited":3,"rest":{');
    expect(parseDraft(broken)).toBeUndefined();
  });
});

describe('search', () => {
  const found = (query: string): string[] =>
    searchGraph(graph, query).map(({ node, where, text }) => `${node} ${where} ${text}`);

  it('finds names, topics, formats and topics between modules', () => {
    expect(found('/IN')).toEqual(['topic:/in name /in']);
    expect(found('/ab')).toEqual(['module:a topic /ab', 'module:b topic /ab']);
    expect(found('double b')[0]).toBe('module:b format double');
    expect(found('b nothing')).toEqual([]);
    expect(found('  ')).toEqual([]);
  });
});
