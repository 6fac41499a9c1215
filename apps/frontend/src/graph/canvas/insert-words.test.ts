import { describe, expect, it } from 'vitest';
import { moduleNode } from '../model/make-node.ts';
import { aGraphOf, aModule } from '../model/testing/small-graph.ts';
import { insertedText, misfitOnWire } from './insert-words.ts';

const graph = aGraphOf([aModule('source', {}, { o: 'double' }), aModule('sink', { i: 'double' })], {
  'source.o': '/a',
  'sink.i': '/a',
});
const [wire] = [...graph.wires.values()];

describe('insert words', () => {
  it('names the formats that do not fit', () => {
    const node = moduleNode(aModule('turn', { v: 'vector2' }, { o: 'double' }));
    expect(misfitOnWire(graph, wire!, node)).toBe(
      'turn is not compatible with this wire: source · o outputs double, but turn · v expects vector2.',
    );
  });

  it('says that a module has no output', () => {
    const node = moduleNode(aModule('log', { v: 'double' }));
    expect(misfitOnWire(graph, wire!, node)).toBe('log has no output for this wire.');
  });

  it('says what to do next', () => {
    const node = moduleNode(aModule('scale', { v: 'double' }, { o: 'double' }));
    const said = 'Inserted scale between source · o and sink · i.';
    expect(insertedText(graph, wire!, node, true)).toBe(said);
    expect(insertedText(graph, wire!, node, false)).toBe(`${said} Start the session to run it.`);
  });
});
