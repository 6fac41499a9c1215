import { MeteredPatterns } from '@ubii/patterns';
import { Re2Patterns } from '@ubii/patterns/re2';
import { fromJson, type TopicMux } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { graphOf } from '../graph-of.ts';
import { aModule, aSessionOf } from '../testing/small-graph.ts';
import { demuxPreview, muxPreview } from './mux-preview.ts';
import { problemsInGraph } from './problems-in-graph.ts';

const patterns = new Re2Patterns();
const mux = (init: object): TopicMux => fromJson('ubii.devices.TopicMux', init);
const UUID = '0f8fad5b-d9cb-469f-a165-70867728950e';
const topics = [
  { topic: `/${UUID}/phone/touch`, format: 'ubii.dataStructure.Vector2', publisherId: 'ann' },
  { topic: '/b/phone/touch', format: 'double' },
  { topic: '/b/phone/color', format: '' },
];

describe('the preview of a muxer', () => {
  it('tells what is selected, apart, and left out [PM-41] [PM-42] [PM-43]', () => {
    expect(
      muxPreview(mux({ topicGlob: '/*/phone/touch', dataType: 'vector2' }), topics, undefined),
    ).toEqual({
      kind: 'matches',
      matches: [
        { topic: `/${UUID}/phone/touch`, identity: 'ann', fits: true },
        { topic: '/b/phone/touch', identity: '/b/phone/touch', fits: false },
      ],
    });
    const own = { topicSelector: 'phone', identityMatchPattern: '^/(.)/', identityGroup: 1 };
    expect(muxPreview(mux(own), topics, patterns)).toMatchObject({
      matches: [{ identity: undefined }, { identity: 'b' }, { identity: 'b' }],
    });
  });

  it('asks for the topics of components', () => {
    const profile = mux({ component: { tags: ['touch'] }, topicGlob: '/**' });
    const found = muxPreview(profile, topics, undefined, ({ tags }) =>
      tags.includes('touch') ? new Set(['/b/phone/touch']) : new Set(),
    );
    expect(found).toMatchObject({ matches: [{ topic: '/b/phone/touch' }] });
  });

  it('says what is wrong with a pattern', () => {
    expect(muxPreview(mux({}), topics, patterns)).toMatchObject({ kind: 'fault' });
    expect(muxPreview(mux({ topicSelector: '(' }), topics, patterns)).toMatchObject({
      kind: 'fault',
      reason: expect.stringContaining('The pattern cannot be used') as string,
    });
  });
});

describe('the preview of a muxer with an expression that others wrote [TD-65]', () => {
  const slow = mux({ topicSelector: '(a+)+$', identityMatchPattern: '^(b|bb)+$' });
  const long = [`/${'a'.repeat(1000)}!`, '/aaa'].map((topic) => ({ topic, format: 'double' }));

  it('ends, though it stalls other engines', () => {
    expect(muxPreview(slow, long, patterns)).toMatchObject({ matches: [{ topic: '/aaa' }] });
  });

  it('says so when it takes too long', () => {
    const spent = new MeteredPatterns(patterns, {
      budget: { spend: () => false },
      monotonicMs: () => 0,
    });
    expect(muxPreview(slow, long, spent)).toMatchObject({
      kind: 'fault',
      reason: expect.stringContaining('takes too long') as string,
    });
  });

  it('waits for the code that matches', () => {
    expect(muxPreview(slow, long, undefined)).toMatchObject({ kind: 'fault' });
  });
});

describe('the preview of a demuxer [PM-45]', () => {
  it('shows topics for identities, or what is missing', () => {
    const format = (outputTopicFormat: string): object =>
      demuxPreview({ outputTopicFormat }, ['ann', 'bob']);
    expect(format('/{{#0}}/vibrate')).toEqual({
      kind: 'topics',
      topics: ['/ann/vibrate', '/bob/vibrate'],
    });
    expect(format('/{{identity}}/a')).toMatchObject({ topics: ['/ann/a', '/bob/a'] });
    expect(format('/same')).toMatchObject({ kind: 'fault' });
    expect(format('/{{#0}}/{{#1}}')).toMatchObject({ kind: 'fault' });
  });
});

describe('problems', () => {
  it('are at their ports and wires', () => {
    const session = aSessionOf([aModule('a', { i: 'double' })], { 'a.i': '/in' });
    const problem = (init: object) => fromJson('ubii.extension.SessionProblem', init);
    const problems = [
      problem({ path: 'ioMappings[0].inputMappings[0].topic', message: 'one' }),
      problem({ path: 'processingModules[0]', moduleId: 'a', message: 'two' }),
      problem({ path: '', message: 'three' }),
    ];
    expect(problemsInGraph(graphOf(session), session, problems)).toEqual([
      {
        problem: problems[0],
        node: 'module:a',
        port: 'in:i',
        wires: ['topic:/in out > module:a in:i'],
      },
      { problem: problems[1], node: 'module:a', port: undefined, wires: [] },
      { problem: problems[2], node: undefined, port: undefined, wires: [] },
    ]);
  });
});
