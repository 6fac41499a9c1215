import { fromJson } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { applyCommand } from '../commands/apply-command.ts';
import { graphOf } from '../graph-of.ts';
import type { Graph } from '../graph.ts';
import { aModule, aSessionOf } from '../testing/small-graph.ts';
import { cyclesIn } from './cycles.ts';
import { graphProblems } from './graph-problems.ts';
import type { Surroundings } from './own-problems.ts';

const AROUND: Surroundings = { modules: undefined, nodes: undefined, writers: new Map() };
const double = (name: string) => aModule(name, { i: 'double' }, { o: 'double' });

describe('problems that can be seen', () => {
  it('a mapping that no longer fits is at its input and its wire', () => {
    const before = aSessionOf([aModule('a', {}, { o: 'double' }), aModule('b', { i: 'double' })], {
      'a.o': '/t',
      'b.i': '/t',
    });
    const { graph } = applyCommand(graphOf(before), {
      kind: 'setModule',
      node: 'module:b',
      changes: { inputs: aModule('b', { i: 'vector2' }).inputs },
    });
    const { ofPort, ofWire } = graphProblems(graph, before, AROUND);
    expect(ofPort.get('module:b in:i')).toMatchObject([{ code: 'format_mismatch', isError: true }]);
    expect(ofWire.size).toBe(1);
  });

  it('an unknown module without code', () => {
    const nothing = { ...aModule('gone'), onProcessingStringified: '' };
    const session = aSessionOf([nothing, double('a')]);
    const around = { ...AROUND, modules: new Set(['low-pass']) };
    const { ofNode } = graphProblems(graphOf(session), session, around);
    expect([...ofNode.keys()]).toEqual(['module:gone']);
    expect(ofNode.get('module:gone')?.[0]?.message).toContain('Import it');
    expect(graphProblems(graphOf(session), session, AROUND).all).toEqual([]);
  });

  it('a module whose node is not there', () => {
    const session = aSessionOf([{ ...double('a'), nodeId: 'away' }]);
    const around = { ...AROUND, nodes: new Set(['master']) };
    const { ofNode } = graphProblems(graphOf(session), session, around);
    expect(ofNode.get('module:a')).toMatchObject([{ code: 'node_unavailable', isError: false }]);
  });

  it('a topic that another session writes, too, where it is: its node, or its wires', () => {
    const others = [{ id: 's2', name: 'Other' }];
    const around = { ...AROUND, writers: new Map([['/t', others]]) };
    const alone = aSessionOf([double('a')], { 'a.o': '/t' });
    const atTopic = graphProblems(graphOf(alone), alone, around);
    expect(atTopic.ofNode.get('topic:/t')).toMatchObject([
      { code: 'topic_written_elsewhere', isError: false, others },
    ]);
    expect(atTopic.all[0]?.message).toContain('"Other"');
    expect(atTopic.all[0]?.remedy).toBeUndefined();
    const asked: (readonly string[])[] = [];
    const useOwnTopics = (topics: readonly string[]) => void asked.push(topics);
    const [problem] = graphProblems(graphOf(alone), alone, { ...around, useOwnTopics }).all;
    expect(problem?.remedy?.text).toBe('Use topics of its own');
    problem?.remedy?.run?.();
    expect(asked).toEqual([['/t']]);
    const chain = aSessionOf([double('a'), double('b')], { 'a.o': '/t', 'b.i': '/t' });
    const graph = graphOf(chain);
    const { ofPort, ofWire } = graphProblems(graph, chain, around);
    expect([...ofPort.keys()]).toEqual(['module:a out:o']);
    expect([...ofWire.keys()]).toEqual([...graph.wires.keys()]);
    const rests = applyCommand(graph, {
      kind: 'setStanding',
      nodes: ['module:a'],
      standing: 'muted',
    }).graph;
    expect(graphProblems(rests, chain, around).all).toEqual([]);
    const reads = aSessionOf([double('b')], { 'b.i': '/t' });
    expect(graphProblems(graphOf(reads), reads, around).all).toEqual([]);
  });

  it('two modules that write one topic', () => {
    const session = aSessionOf([double('a'), double('b')], { 'a.o': '/t', 'b.o': '/t' });
    const { ofNode, ofWire } = graphProblems(graphOf(session), session, AROUND);
    expect(ofNode.get('topic:/t')).toMatchObject([{ code: 'topic_written_twice' }]);
    expect(ofWire.size).toBe(2);
  });

  it('modules that feed each other', () => {
    const session = aSessionOf([double('a'), double('b'), double('c')], {
      'a.o': '/1',
      'b.i': '/1',
      'b.o': '/2',
      'a.i': '/2',
      'c.i': '/2',
    });
    const graph = graphOf(session);
    const [cycle] = cyclesIn(graph);
    expect([...cycle!.nodes].sort()).toEqual(['module:a', 'module:b']);
    const { ofNode } = graphProblems(graph, session, AROUND);
    expect(ofNode.get('module:b')).toMatchObject([{ code: 'cycle', isError: false }]);
    expect(ofNode.has('module:c')).toBe(false);
  });
});

describe('problems the master tells', () => {
  const problem = (init: object) => fromJson('ubii.extension.SessionProblem', init);
  const session = {
    ...aSessionOf([double('a')], { 'a.i': '/in' }),
    extension: fromJson('ubii.extension.SessionExtension', {
      problems: [
        problem({
          code: 'topic_without_record',
          path: 'ioMappings[0].inputMappings[0].topic',
          message: 'No client publishes.',
        }),
        problem({ code: 'node_gone', message: 'All is lost.', isError: true }),
      ],
    }),
  };

  it('have what to do about a topic on which nothing is sent, where it is known', () => {
    const remedy = { message: 'Touch the pad.', text: 'Open it', to: '/pad' };
    const remedyOf = (topic: string) => (topic === '/in' ? remedy : undefined);
    const { ofPort } = graphProblems(graphOf(session), session, { ...AROUND, remedyOf });
    expect(ofPort.get('module:a in:i')).toMatchObject([{ message: 'Touch the pad.', remedy }]);
  });

  it('say what is known of a topic for which there is nothing to do', () => {
    const remedyOf = () => ({ message: 'Its client has left.' });
    const { ofPort } = graphProblems(graphOf(session), session, { ...AROUND, remedyOf });
    expect(ofPort.get('module:a in:i')).toMatchObject([{ message: 'Its client has left.' }]);
    expect(ofPort.get('module:a in:i')?.[0]).not.toHaveProperty('remedy');
  });

  it('leave out a topic that was replaced since', () => {
    const rewired = applyCommand(graphOf(session), {
      kind: 'renameTopic',
      node: 'topic:/in',
      topic: '/other',
    });
    expect(graphProblems(rewired.graph, session, AROUND).ofPort.size).toBe(0);
    const back = applyCommand(rewired.graph, rewired.inverse).graph;
    expect(graphProblems(back, session, AROUND).ofPort.size).toBe(1);
  });

  it('leave out a topic that merely rests', () => {
    const isResting = (topic: string) => topic === '/in';
    const { all, ofPort } = graphProblems(graphOf(session), session, { ...AROUND, isResting });
    expect(all.map(({ code }) => code)).toEqual(['node_gone']);
    expect(ofPort.size).toBe(0);
  });

  it('come errors first, also those of the session as a whole', () => {
    const { all } = graphProblems(graphOf(session), session, AROUND);
    expect(all.map(({ message }) => message)).toEqual(['All is lost.', 'No client publishes.']);
  });

  it('go when the wire they are about is gone', () => {
    const graph: Graph = { ...graphOf(session), wires: new Map() };
    expect(graphProblems(graph, session, AROUND).ofPort.size).toBe(0);
  });

  it('are not said twice', () => {
    const cycle = aSessionOf([double('a')], { 'a.i': '/1', 'a.o': '/1' });
    const told = problem({ code: 'cycle', moduleId: 'a', message: 'feeds itself' });
    const extension = fromJson('ubii.extension.SessionExtension', { problems: [told] });
    const { ofNode } = graphProblems(graphOf(cycle), { ...cycle, extension }, AROUND);
    expect(ofNode.get('module:a')).toHaveLength(1);
  });
});
