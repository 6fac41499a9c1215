import { fromJson, type Session } from '@ubii/proto';
import { EXAMPLE_SESSIONS } from '@ubii/modules';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { graphOf } from './graph-of.ts';
import type { Graph } from './graph.ts';
import { sessionOf } from './session-of.ts';
import { arbitrarySession } from './testing/arbitrary-session.ts';

const session = (json: object): Session => fromJson('ubii.sessions.Session', json);
const wires = (graph: Graph): string[] =>
  [...graph.wires.values()].map(({ id, via }) => (via === undefined ? id : `${id} via ${via}`));

/** Many sessions take long on a busy computer. */
const TIMEOUT_MS = 60_000;

describe('a session as a graph', { timeout: TIMEOUT_MS }, () => {
  it('comes back as it was, whatever it is [SE-6]', () => {
    fc.assert(
      fc.property(arbitrarySession, (one) => {
        expect(sessionOf(graphOf(one), one)).toStrictEqual(one);
      }),
      { numRuns: 500 },
    );
  });

  it('has no constant without a value', () => {
    const nodes = {
      'constant:1': { kind: 'constant' },
      'constant:2': { kind: 'constant', json: '1' },
    };
    const editorJson = JSON.stringify({ format: 'ubi-interact.graph', version: 1, nodes });
    const graph = graphOf(session({ extension: { editorJson } }));
    expect([...graph.nodes.keys()]).toEqual(['constant:2']);
  });

  it('is the same each time', () => {
    fc.assert(
      fc.property(arbitrarySession, (one) => {
        expect(graphOf(structuredClone(one))).toEqual(graphOf(one));
      }),
    );
  });

  it('wires only what is there', () => {
    fc.assert(
      fc.property(arbitrarySession, (one) => {
        const { nodes, wires } = graphOf(one);
        for (const { from, to } of wires.values()) {
          expect(nodes.get(from.node)?.ports).toContainEqual(
            expect.objectContaining({ id: from.port, direction: 'out' }),
          );
          expect(nodes.get(to.node)?.ports).toContainEqual(
            expect.objectContaining({ id: to.port, direction: 'in' }),
          );
        }
        for (const [id, node] of nodes) expect(node.id).toBe(id);
        for (const [id, wire] of wires) expect(wire.id).toBe(id);
      }),
      { numRuns: 200 },
    );
  });

  it('gives a module that comes back no mapping that belonged to none', () => {
    const one = session({
      processingModules: [{ id: 'a', name: 'blur' }],
      ioMappings: [
        {
          processingModuleName: 'blur',
          outputMappings: [{ outputName: 'out', topic: '/left-over' }],
        },
        { processingModuleId: 'a' },
      ],
    });
    const before = graphOf(one);
    expect(wires(before)).toEqual([]);
    const without = sessionOf({ ...before, nodes: new Map() }, one);
    expect(wires(graphOf(sessionOf(before, without)))).toEqual([]);
  });

  it('comes back from the examples', () => {
    for (const example of Object.values(EXAMPLE_SESSIONS)) {
      const one = session(example);
      expect(sessionOf(graphOf(one), one)).toStrictEqual(one);
    }
  });
});

describe('topics', () => {
  const chain = {
    processingModules: [
      { id: 'a', name: 'A', outputs: [{ internalName: 'o', messageFormat: 'double' }] },
      { id: 'b', name: 'B', inputs: [{ internalName: 'i', messageFormat: 'double' }] },
    ],
    ioMappings: [
      { processingModuleId: 'a', outputMappings: [{ outputName: 'o', topic: '/t' }] },
      { processingModuleId: 'b', inputMappings: [{ inputName: 'i', topic: '/t' }] },
    ],
  };

  it('between modules are wires', () => {
    expect(wires(graphOf(session(chain)))).toEqual(['module:a out:o > module:b in:i via /t']);
  });

  it('between modules are nodes when the editor has put them somewhere', () => {
    const editorJson = JSON.stringify({
      format: 'ubi-interact.graph',
      version: 1,
      nodes: { 'topic:/t': { kind: 'topic', x: 3, y: 4 } },
    });
    const graph = graphOf(session({ ...chain, extension: { editorJson } }));
    expect(wires(graph)).toEqual(['topic:/t out > module:b in:i', 'module:a out:o > topic:/t in']);
    expect(graph.nodes.get('topic:/t')?.position).toEqual({ x: 3, y: 4 });
  });

  it('that two modules write are nodes', () => {
    const [writer, reader] = chain.ioMappings;
    const graph = graphOf(
      session({
        processingModules: [...chain.processingModules, { id: 'c', name: 'C' }],
        ioMappings: [writer, reader, { ...writer, processingModuleId: 'c' }],
      }),
    );
    expect(wires(graph)).toEqual([
      'topic:/t out > module:b in:i',
      'module:a out:o > topic:/t in',
      'module:c out:o > topic:/t in',
    ]);
    expect(graph.nodes.get('module:c')?.ports).toMatchObject([{ id: 'out:o', isDeclared: false }]);
  });
});

describe('mappings', () => {
  it('without an id belong to modules of their name in order [SE-2]', () => {
    const io = { inputs: [{ internalName: 'i', messageFormat: 'double' }] };
    const graph = graphOf(
      session({
        processingModules: [
          { id: 'one', name: 'A', ...io },
          { id: 'two', name: 'A', ...io },
        ],
        ioMappings: [
          { processingModuleName: 'A', inputMappings: [{ inputName: 'i', topic: '/1' }] },
          { processingModuleName: 'A', inputMappings: [{ inputName: 'i', topic: '/2' }] },
          { processingModuleName: 'Z', inputMappings: [{ inputName: 'i', topic: '/3' }] },
        ],
      }),
    );
    expect(wires(graph)).toEqual([
      'topic:/1 out > module:one in:i',
      'topic:/2 out > module:two in:i',
    ]);
  });

  it('of one muxer are one node, of two that look alike two', () => {
    const topicMux = { id: 'm', topicGlob: '/*/x', dataType: 'double' };
    const inputMappings = ['i', 'j'].map((inputName) => ({ inputName, topicMux }));
    const of = (mappings: object[]): string[] =>
      wires(
        graphOf(
          session({
            processingModules: [{ id: 'a', name: 'A' }],
            ioMappings: [{ processingModuleId: 'a', inputMappings: mappings }],
          }),
        ),
      );
    expect(of(inputMappings)).toEqual([
      'muxer:m out > module:a in:i',
      'muxer:m out > module:a in:j',
    ]);
    expect(of([inputMappings[0]!, { inputName: 'j', topicMux: { id: 'm' } }])).toEqual([
      'muxer:m out > module:a in:i',
      'muxer:m #2 out > module:a in:j',
    ]);
  });
});
