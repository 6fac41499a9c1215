import { describe, expect, it } from 'vitest';
import {
  longestDecay,
  moduleRuns,
  outputDecays,
  outputWithin,
  serviceRefused,
  serviceReplied,
  topicArrives,
  tryIsFed,
  valueCovers,
  valuesMirror,
  valueStays,
} from './checks.ts';
import { NO_FACTS, NO_VALUES, withValue, type LessonFacts, type TopicFact } from './facts.ts';

const named = { id: 'it', text: 'it', todo: 'it' };
const topic = (name: string, hz: number, ...values: (readonly number[])[]): TopicFact => ({
  topic: name,
  format: 'vector2',
  hz,
  ...values.reduce(withValue, NO_VALUES),
});
const withTopics = (...topics: TopicFact[]): LessonFacts => ({
  ...NO_FACTS,
  topics: new Map(topics.map((one) => [one.topic, one])),
});
const find =
  (name: string) =>
  ({ topics }: LessonFacts): TopicFact | undefined =>
    topics.get(name);

describe('checks of topics', () => {
  it('measures the rate at which records arrive', () => {
    const check = topicArrives(find('/a'), 5, named);
    expect(check.measure(NO_FACTS)).toEqual({ passed: false, value: '' });
    expect(check.measure(withTopics(topic('/a', 3)))).toEqual({ passed: false, value: '3.0 Hz' });
    expect(check.measure(withTopics(topic('/a', 59.7)))).toEqual({ passed: true, value: '60 Hz' });
  });

  it('measures how far both numbers have moved', () => {
    const check = valueCovers(find('/a'), 0.5, named);
    const line = withTopics(topic('/a', 9, [0.1, 0.4], [0.9, 0.5]));
    expect(check.measure(line)).toEqual({ passed: false, value: '0.80 × 0.10' });
    const circle = withTopics(topic('/a', 9, [0.1, 0.4], [0.9, 0.5], [0.5, 0.95]));
    expect(check.measure(circle).passed).toBe(true);
  });

  it('finds a retained value when the rate is 0', () => {
    const check = valueStays(find('/a'), named);
    expect(check.measure(withTopics(topic('/a', 0))).passed).toBe(false);
    expect(check.measure(withTopics(topic('/a', 4, [0.5, 0.5]))).passed).toBe(false);
    expect(check.measure(withTopics(topic('/a', 0, [0.5, 0.25])))).toEqual({
      passed: true,
      value: '0.0 Hz, value 0.50 0.25',
    });
  });

  it('tells a mirrored value from a plain one', () => {
    const check = valuesMirror(find('/a'), find('/b'), named);
    const pair = (a: number, b: number): LessonFacts =>
      withTopics(topic('/a', 1, [a, 0]), topic('/b', 1, [b, 0]));
    expect(check.measure(pair(0.2, 0.2)).passed).toBe(false);
    expect(check.measure(pair(0.5, 0.5)).passed).toBe(false);
    expect(check.measure(pair(0.2, 0.8))).toEqual({ passed: true, value: '0.20 + 0.80 = 1.00' });
  });
});

describe('checks of modules', () => {
  const tried = (series: readonly number[], isRunning = true): LessonFacts => ({
    ...NO_FACTS,
    tried: { isRunning, runs: series.length, runsPerSecond: 30, inputTopic: undefined, series },
  });

  it('counts the runs that a node reports', () => {
    const check = moduleRuns('m', 5, named);
    const session = { name: 's', isRunning: true, state: 'Running' };
    const running = { ...session, runsPerSecond: new Map([['m', 29.6]]) };
    expect(check.measure({ ...NO_FACTS, session: running })).toEqual({
      passed: true,
      value: '30 runs/s',
    });
    const other = { ...session, runsPerSecond: new Map([['x', 30]]) };
    expect(check.measure({ ...NO_FACTS, session: other }).passed).toBe(false);
  });

  it('looks at the newest output only while the try-out runs', () => {
    const check = outputWithin(0.2, 9, named);
    expect(check.measure(tried([0, 0.84]))).toEqual({ passed: true, value: '0.840' });
    expect(check.measure(tried([0, 0.84], false)).passed).toBe(false);
    expect(check.measure(tried([0.84, 0])).passed).toBe(false);
  });

  it('finds the topic that feeds the try-out', () => {
    const check = tryIsFed(5, named);
    const fed = { ...tried([1]).tried!, inputTopic: '/a' };
    expect(check.measure({ ...withTopics(topic('/a', 60)), tried: fed }).passed).toBe(true);
    expect(check.measure({ ...withTopics(topic('/b', 60)), tried: fed }).passed).toBe(false);
  });

  it('tells smoothing from values that stop at once', () => {
    const smooth = Array.from({ length: 12 }, (_, index) => 0.8 ** index);
    expect(longestDecay(smooth)).toBe(11);
    expect(longestDecay([1, 0.9, 1.1, 0, 0, 0])).toBe(1);
    expect(outputDecays(8, named).measure(tried([0, 0, ...smooth]))).toEqual({
      passed: true,
      value: 'over 11 runs',
    });
    expect(outputDecays(8, named).measure(tried([1, 1.2, 0, 0, 0])).passed).toBe(false);
  });
});

describe('checks of services', () => {
  const call = { service: 'topicList', request: undefined, tookMs: 2 } as const;

  it('reads the newest reply', () => {
    const check = serviceReplied('topicList', ({ reply }) => (reply ? 'yes' : undefined), named);
    const replied = { ...call, reply: {}, errorCode: undefined };
    expect(check.measure(NO_FACTS).passed).toBe(false);
    expect(check.measure({ ...NO_FACTS, calls: [replied] })).toEqual({
      passed: true,
      value: 'yes',
    });
    const refused = { ...call, reply: undefined, errorCode: 'unavailable' };
    expect(check.measure({ ...NO_FACTS, calls: [refused, replied] })).toEqual({
      passed: false,
      value: 'unavailable',
    });
  });

  it('reads the code of an error', () => {
    const check = serviceRefused('topicList', 'not_found', named);
    const refused = { ...call, reply: undefined, errorCode: 'not_found' };
    expect(check.measure({ ...NO_FACTS, calls: [refused] })).toEqual({
      passed: true,
      value: 'not_found',
    });
  });
});
