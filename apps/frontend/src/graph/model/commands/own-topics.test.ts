import { describe, expect, it } from 'vitest';
import type { Graph } from '../graph.ts';
import { aGraphOf, aModule, aSessionOf, ref, wiresIn } from '../testing/small-graph.ts';
import { applyCommand } from './apply-command.ts';
import { perform, startEditing, undo } from './edit-state.ts';
import { topicsElsewhere, type TopicsElsewhere } from './topics-elsewhere.ts';

const CLOCK = aModule('clock', {}, { sine: 'double' });
const MAP = aModule('map', { value: 'double' }, { mapped: 'double' });
const WIRED = { 'clock.sine': '/Test/clock/sine', 'map.value': '/Test/clock/sine' };

const named = (graph: Graph, name: string): Graph =>
  applyCommand(graph, { kind: 'setDetails', changes: { name } }).graph;
const writing = (topic: string): TopicsElsewhere =>
  topicsElsewhere([aSessionOf([CLOCK], { 'clock.sine': topic })]);

describe('the topic of a new wire', () => {
  it('is none that another session writes', () => {
    const graph = aGraphOf([CLOCK, MAP]);
    const connect = {
      kind: 'connect',
      from: ref(graph, 'clock.sine'),
      to: ref(graph, 'map.value'),
    } as const;
    const elsewhere = (): TopicsElsewhere => writing('/Test/clock/sine');
    expect(wiresIn(applyCommand(graph, connect, elsewhere).graph)).toEqual([
      'clock.sine > map.value (/Test/clock/sine-2)',
    ]);
    expect(wiresIn(applyCommand(graph, connect).graph)).toEqual([
      'clock.sine > map.value (/Test/clock/sine)',
    ]);
  });

  it('is none that another session writes when nodes are pasted', () => {
    const { nodes, wires } = aGraphOf([CLOCK, MAP], WIRED);
    const add = { kind: 'add', nodes: [...nodes.values()], wires: [...wires.values()] } as const;
    const elsewhere = (): TopicsElsewhere => writing('/Test/clock/sine');
    const { graph } = applyCommand(named(aGraphOf([]), 'Mine'), add, elsewhere);
    expect(wiresIn(graph)).toEqual(['clock.sine > map.value (/Mine/clock/sine)']);
  });
});

describe('a new name of the session', () => {
  const rename = { kind: 'setDetails', changes: { name: 'Arm lights' } } as const;

  it('is in the topics of its wires, and undo is one step', () => {
    const before = startEditing(aGraphOf([CLOCK, MAP], WIRED));
    const after = perform(before, rename);
    expect(wiresIn(after.graph)).toEqual(['clock.sine > map.value (/Arm-lights/clock/sine)']);
    expect(undo(after).graph).toEqual(before.graph);
  });

  it('is in no topic that a person named', () => {
    const mine = { 'clock.sine': '/Test/speed', 'map.value': '/Test/speed' };
    expect(wiresIn(applyCommand(aGraphOf([CLOCK, MAP], mine), rename).graph)).toEqual([
      'clock.sine > map.value (/Test/speed)',
    ]);
  });

  it('is in a topic that the editor proposed for an output, with its wires and points', () => {
    const proposed = { 'clock.sine': '/Test/sine', 'map.value': '/Test/sine' };
    // The node of the topic stays where it is shown.
    const shown = applyCommand(aGraphOf([CLOCK, MAP], { 'clock.sine': '/Test/sine' }), rename);
    expect(wiresIn(shown.graph)).toEqual(['clock.sine > topic:/Arm-lights/sine']);
    const graph = applyCommand(aGraphOf([CLOCK, MAP], proposed), {
      kind: 'showTopic',
      wire: [...aGraphOf([CLOCK, MAP], proposed).wires.keys()][0]!,
    }).graph;
    const [wire] = [...graph.wires.values()].filter(({ to }) => to.node === 'topic:/Test/sine');
    const points = [{ x: 10, y: 20 }];
    const bent = applyCommand(graph, { kind: 'reroute', wire: wire!.id, points }).graph;
    const after = applyCommand(bent, rename).graph;
    expect(wiresIn(after)).toEqual([
      'clock.sine > topic:/Arm-lights/sine',
      'topic:/Arm-lights/sine > map.value',
    ]);
    expect(
      [...after.wires.values()].find(({ to }) => to.node.startsWith('topic:'))?.points,
    ).toEqual(points);
  });

  it('is in no topic that others write, too, or that has another name', () => {
    const two = { 'clock.sine': '/Test/sine', 'map.mapped': '/Test/sine' };
    const other = { 'clock.sine': '/Test/speed' };
    const read = { 'map.value': '/Test/value' };
    for (const mappings of [two, other, read]) {
      const graph = aGraphOf([CLOCK, MAP], mappings);
      expect(wiresIn(applyCommand(graph, rename).graph)).toEqual(wiresIn(graph));
    }
  });

  it('is in no topic that another session reads', () => {
    const reader = aSessionOf([MAP], { 'map.value': '/Test/clock/sine' });
    const elsewhere = (): TopicsElsewhere => topicsElsewhere([reader]);
    const graph = aGraphOf([CLOCK, MAP], WIRED);
    expect(wiresIn(applyCommand(graph, rename, elsewhere).graph)).toEqual([
      'clock.sine > map.value (/Test/clock/sine)',
    ]);
  });

  it('is in no topic that a muxer of this session selects', () => {
    const gather = aModule('gather', { all: 'double[]' });
    const topicMux = { topicGlob: '/Test/*/sine', dataType: 'double' };
    const graph = aGraphOf([CLOCK, MAP, gather], { ...WIRED, 'gather.all': { topicMux } });
    expect(wiresIn(applyCommand(graph, rename).graph)).toContain(
      'clock.sine > map.value (/Test/clock/sine)',
    );
  });
});

describe('topics of its own', () => {
  it('replace those that another session writes, at wires and at topics', () => {
    const elsewhere = (): TopicsElsewhere => ({
      ...writing('/Test/clock/sine'),
      used: new Set(['/Test/clock/sine', '/lamp/level']),
    });
    const graph = aGraphOf([CLOCK, MAP], { ...WIRED, 'map.mapped': '/lamp/level' });
    const topics = ['/Test/clock/sine', '/lamp/level'];
    const state = perform(startEditing(graph), { kind: 'ownTopics', topics }, undefined, elsewhere);
    expect(wiresIn(state.graph)).toEqual([
      'clock.sine > map.value (/Test/clock/sine-2)',
      'map.mapped > topic:/Test/level',
    ]);
    expect(state.past.map(({ label }) => label)).toEqual(['Use topics of its own']);
  });
});
