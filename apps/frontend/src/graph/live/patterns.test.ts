import { describe, expect, it } from 'vitest';
import { applyCommand } from '../model/commands/apply-command.ts';
import { graphOf } from '../model/graph-of.ts';
import type { DemuxerNode } from '../model/graph.ts';
import { newDemuxerNode, newMuxerNode } from '../model/new-node.ts';
import { aModule, aSessionOf } from '../model/testing/small-graph.ts';
import type { MuxPreview } from '../model/live/mux-preview.ts';
import { demuxSamples } from './demux-samples.ts';
import { patternParts } from './pattern-parts.ts';

const open = (text: string, kind: 'glob' | 'regex' | 'format'): string[] =>
  patternParts(text, kind).flatMap((part) => (part.isOpen ? [part.text] : []));

describe('the parts of a pattern', () => {
  it('are marked where they differ from topic to topic', () => {
    expect(open('/*/phone/**', 'glob')).toEqual(['*', '**']);
    expect(open('^/([^/]+)/touch$', 'regex')).toEqual(['([^/]+)']);
    expect(open('/{{#0}}/vibrate/%s', 'format')).toEqual(['{{#0}}', '%s']);
    expect(patternParts('/a/*', 'glob')).toEqual([
      { text: '/a/', isOpen: false },
      { text: '*', isOpen: true },
    ]);
    expect(patternParts('', 'glob')).toEqual([]);
  });
});

describe('the samples of a demuxer', () => {
  const session = aSessionOf([aModule('a', { i: 'double[]' }, { o: 'double[]' })]);
  const demuxer = newDemuxerNode('d', { outputTopicFormat: '/{{#0}}/out' });
  const muxer = newMuxerNode('m', { topicGlob: '/*/in' });
  const matches = (...identities: string[]): MuxPreview => ({
    kind: 'matches',
    matches: identities.map((identity) => ({ topic: `/${identity}/in`, identity, fits: true })),
  });
  const none = (): MuxPreview => matches();

  it('are those of the clients of the muxer before it', () => {
    const first = graphOf(session);
    const { graph } = applyCommand(first, { kind: 'add', nodes: [demuxer, muxer] });
    const module = { node: 'module:a', port: 'in:i' };
    const from = { node: 'module:a', port: 'out:o' };
    const wires = new Map([
      ['1', wire('1', { node: muxer.id, port: 'out' }, module)],
      ['2', wire('2', from, { node: demuxer.id, port: 'in' })],
    ]);
    const samples = demuxSamples({ ...graph, wires }, demuxer, () => matches('ann', 'bob'));
    expect(samples).toMatchObject({
      identities: ['ann', 'bob'],
      preview: { kind: 'topics', topics: ['/ann/out', '/bob/out'] },
      isExample: false,
    });
  });

  it('are samples when no client is connected, and report errors in the format', () => {
    expect(demuxSamples(graphOf(session), demuxer, none)).toMatchObject({
      preview: { kind: 'topics', topics: ['/identity/out'] },
      isExample: true,
    });
    const plain: DemuxerNode = newDemuxerNode('e', { outputTopicFormat: '/same' });
    expect(demuxSamples(graphOf(session), plain, none).preview.kind).toBe('fault');
  });

  function wire(
    id: string,
    from: { node: string; port: string },
    to: { node: string; port: string },
  ) {
    return { id, from, to, via: undefined, points: [] };
  }
});
