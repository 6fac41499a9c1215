import { expect, it } from 'vitest';
import { runningTopics } from './running-topics.ts';

const MASTER = '729eaeb0-49d7-451a-8ad1-e61fb4e201c2';
const topic = (name: string, clientId: string, recordCount: number) => ({
  topic: name,
  clientId,
  recordCount,
  dataFormat: 'double',
  clientName: clientId === MASTER ? '' : 'Robot',
});

it('the topics of a running recording have names and rates, those that stopped and those that are new', () => {
  const writers = new Map([['/energy', 'Classifier']]);
  const first = { atMs: 0, topics: [topic('/angle', 'r', 10), topic('/energy', MASTER, 5)] };
  const at = (list: ReturnType<typeof runningTopics>) =>
    list.map(({ label, owner, records, hz }) => [label, owner, records, hz]);
  expect(at(runningTopics(undefined, first, writers))).toEqual([
    ['/angle', 'Robot', 10, undefined],
    ['/energy', 'Classifier', 5, undefined],
  ]);
  const topics = [
    ...[topic('/angle', 'r', 30), topic('/energy', MASTER, 5), topic('/new', 'r', 2)],
    // A second publisher of a topic.
    topic('/angle', 's', 4),
  ];
  expect(at(runningTopics(first, { atMs: 2000, topics }, writers))).toEqual([
    ['/angle', 'Robot', 34, 12],
    ['/energy', 'Classifier', 5, 0],
    ['/new', 'Robot', 2, 1],
  ]);
});
