import { expect, it, vi } from 'vitest';
import { leftTopicAdvice, type OtherTopics } from './left-topic-advice.ts';

const GONE = 'b0c47f3b-1111-4222-8333-444455556666';
const HERE = 'c1d58a4c-1111-4222-8333-444455556666';
const NEXT = 'd2e69b5d-1111-4222-8333-444455556666';
const topicOf = (id: string, rest = 'web-example/duration') => `/${id}/${rest}`;
const published = (topic: string) => ({ topic, format: 'double' });

function around(changes: Partial<OtherTopics> = {}): OtherTopics {
  const names = new Map([
    [GONE, { name: 'Copper Lynx', isAway: true }],
    [HERE, { name: 'Amber Newt', isAway: false }],
    [NEXT, { name: 'Quick Tern', isAway: false }],
  ]);
  return {
    findPublisher: (id) => names.get(id),
    isPresent: (id) => id !== GONE,
    topics: () => [],
    fits: () => true,
    use: () => undefined,
    ...changes,
  };
}

it('names the client of a topic that has left, and what to do', () => {
  expect(leftTopicAdvice(topicOf(GONE), around())).toEqual({
    message:
      'Topic "web-example/duration" has no value: its client Copper Lynx has left. Connect a topic of another client.',
  });
  const isPresent = () => true;
  expect(leftTopicAdvice(topicOf(GONE), around({ isPresent }))?.message).toContain(
    'has no value: its client Copper Lynx is not connected.',
  );
});

it('offers the topic of the same device and component of another client', () => {
  const use = vi.fn();
  const topics = () => [published(topicOf(HERE)), published(topicOf(HERE, 'web-example/other'))];
  const advice = leftTopicAdvice(topicOf(GONE), around({ topics, use }));
  expect(advice).toMatchObject({
    message:
      'Topic "web-example/duration" has no value: its client Copper Lynx has left. Amber Newt publishes the same topic.',
    text: 'Use duration of Amber Newt',
  });
  advice?.run?.();
  expect(use).toHaveBeenCalledWith(topicOf(HERE));
});

it('takes the first of several, and offers nothing that does not fit', () => {
  const topics = () => [published(topicOf(NEXT)), published(topicOf(HERE))];
  expect(leftTopicAdvice(topicOf(GONE), around({ topics }))?.text).toBe(
    'Use duration of Quick Tern',
  );
  const fits = () => false;
  expect(leftTopicAdvice(topicOf(GONE), around({ topics, fits }))).not.toHaveProperty('text');
});

it('says nothing of topics of clients that are there, and of topics of no client', () => {
  expect(leftTopicAdvice(topicOf(HERE), around())).toBeUndefined();
  expect(leftTopicAdvice('/arm/angle', around())).toBeUndefined();
});
