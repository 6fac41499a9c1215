import { moduleLibrary } from '@ubii/modules';
import { describe, expect, it } from 'vitest';
import { graphOf } from '../../graph/model/graph-of.ts';
import { manyPhones } from '../lessons/many-phones.ts';
import { lessonTopic, pointerTopic } from '../lessons/topics.ts';
import { wireTwoTopics } from '../lessons/wire-two-topics.ts';
import { answersBefore, lessonSessionAt, type GraphParts } from './lesson-graphs.ts';

const clientId = '3a1b5c7d-0000-4000-8000-000000000001';
let count = 0;
const parts: GraphParts = {
  clientId,
  library: moduleLibrary(),
  uuid: () => `00000000-0000-4000-8000-${String((count += 1)).padStart(12, '0')}`,
};

describe('the graph of a lesson', () => {
  it('begins with two topics and a module that nothing is wired to', () => {
    const session = lessonSessionAt('mirror', [], parts);
    const graph = graphOf(session);
    expect([...graph.nodes.values()].map(({ kind }) => kind).sort()).toEqual([
      'module',
      'topic',
      'topic',
    ]);
    expect(graph.wires.size).toBe(0);
  });

  it('has what the steps before have wired', () => {
    const session = lessonSessionAt('mirror', answersBefore(wireTwoTopics, 4), parts);
    expect(session.ioMappings[0]).toMatchObject({
      inputMappings: expect.arrayContaining([
        expect.objectContaining({ inputName: 'pointer', topic: pointerTopic(clientId) }),
        expect.objectContaining({ inputName: 'mirrorX', constantJson: '{"bool":true}' }),
      ]) as unknown,
      outputMappings: [{ outputName: 'mirrored', topic: lessonTopic(clientId, 'mirrored') }],
    });
    expect(answersBefore(wireTwoTopics, 2)).toEqual(['wire-in']);
  });

  it('gathers the fingers of all phones with a muxer', () => {
    const session = lessonSessionAt('many-phones', answersBefore(manyPhones, 2), parts);
    const [mapping] = session.ioMappings;
    const touches = mapping?.inputMappings.find(({ inputName }) => inputName === 'touches');
    expect(touches?.topicMux).toMatchObject({
      topicGlob: '/*/web-interface-smart-device/touch_position',
    });
    expect(mapping?.outputMappings).toMatchObject([
      { outputName: 'nearCount', topic: lessonTopic(clientId, 'near') },
    ]);
  });
});
