import { describe, expect, it } from 'vitest';
import { applyCommand } from '../commands/apply-command.ts';
import { graphOf } from '../graph-of.ts';
import type { Graph, Standing } from '../graph.ts';
import { sessionOf } from '../session-of.ts';
import { aModule, aSessionOf, wiresIn } from '../testing/small-graph.ts';

const io = { i: 'double', cutoff: 'double' };
const session = aSessionOf(
  ['a', 'b', 'c'].map((name) => aModule(name, io, { o: 'double' })),
  { 'a.i': '/in', 'a.o': '/ab', 'b.i': '/ab', 'b.o': '/bc', 'c.i': '/bc', 'c.o': '/out' },
);
const graph = graphOf(session);
const put = (start: Graph, standing: Standing, ...names: string[]): Graph =>
  applyCommand(start, {
    kind: 'setStanding',
    nodes: names.map((name) => `module:${name}`),
    standing,
  }).graph;
/** The session as old clients see it, without the extension. */
const plain = (one: typeof session): Graph => graphOf({ ...one, extension: undefined });

describe('a module that is bypassed', () => {
  it('is not run, and what fed it feeds what it fed', () => {
    const saved = sessionOf(put(graph, 'bypassed', 'b'), session);
    expect(saved.processingModules.map(({ name }) => name)).toEqual(['a', 'c']);
    expect(wiresIn(plain(saved))).toEqual([
      'a.o > c.i (/ab)',
      'c.o > topic:/out',
      'topic:/in > a.i',
    ]);
  });

  it('is there as before when the session is opened again, and works again', () => {
    const bypassed = put(graph, 'bypassed', 'b');
    const saved = sessionOf(bypassed, session);
    const opened = graphOf(saved);
    expect(opened.nodes.get('module:b')).toMatchObject({ standing: 'bypassed' });
    expect(wiresIn(opened)).toEqual(wiresIn(graph));
    expect(sessionOf(opened, saved)).toStrictEqual(saved);
    const again = sessionOf(put(opened, 'active', 'b'), saved);
    expect(again.processingModules).toEqual(session.processingModules);
    expect(again.ioMappings).toEqual(session.ioMappings);
  });

  it('lets values through beside others that are', () => {
    const saved = sessionOf(put(graph, 'bypassed', 'a', 'b'), session);
    expect(wiresIn(plain(saved))).toEqual(['c.o > topic:/out', 'topic:/in > c.i']);
  });

  it('keeps changes made meanwhile', () => {
    const saved = sessionOf(put(graph, 'bypassed', 'b'), session);
    const [first, second] = saved.ioMappings;
    const [input] = second!.inputMappings;
    const ioMappings = [first!, { ...second!, inputMappings: [{ ...input!, topic: '/else' }] }];
    expect(wiresIn(graphOf({ ...saved, ioMappings }))).toContain('topic:/else > c.i');
  });
});

describe('a module that is muted', () => {
  it('is not run, and nothing takes its place', () => {
    const saved = sessionOf(put(graph, 'muted', 'b'), session);
    expect(wiresIn(plain(saved))).toEqual([
      'a.o > topic:/ab',
      'c.o > topic:/out',
      'topic:/bc > c.i',
      'topic:/in > a.i',
    ]);
    expect(wiresIn(graphOf(saved))).toEqual(wiresIn(graph));
  });
});
