import type { ServiceName } from '@ubii/proto';
import { plural } from '@ubii/words';
import type { CallFact, LessonFacts, TopicFact } from './facts.ts';
import type { Check, Measurement } from './lesson.ts';

type Named = Pick<Check, 'id' | 'text' | 'todo'>;
type TopicOf = (facts: LessonFacts) => TopicFact | undefined;

const NOTHING: Measurement = { passed: false, value: '' };
const perSecond = (value: number): string => (value < 10 ? value.toFixed(1) : value.toFixed(0));
const hertz = (hz: number): string => `${perSecond(hz)} Hz`;
const part = (value: number): string => value.toFixed(2);

/** Returns the topics whose names end with a text, highest rate first. */
export function topicsThatEnd(facts: LessonFacts, end: string): readonly TopicFact[] {
  return [...facts.topics.values()]
    .filter(({ topic }) => topic.endsWith(end))
    .sort((a, b) => b.hz - a.hz || a.topic.localeCompare(b.topic));
}

/** Requires a number of connected phones. */
export function phonesConnected(count: number, named: Named): Check {
  return {
    ...named,
    measure({ phones }) {
      if (phones.length === 0) return NOTHING;
      const value = count === 1 ? (phones[0]?.name ?? '') : `${phones.length} phones`;
      return { passed: phones.length >= count, value };
    },
  };
}

/** Requires a minimum rate of records. */
export function topicArrives(topicOf: TopicOf, minHz: number, named: Named): Check {
  return {
    ...named,
    measure(facts) {
      const topic = topicOf(facts);
      if (topic === undefined) return NOTHING;
      return { passed: topic.hz >= minHz, value: hertz(topic.hz) };
    },
  };
}

/** Requires that each of the first two numbers has changed by at least `span` since the step started. */
export function valueCovers(topicOf: TopicOf, span: number, named: Named): Check {
  return {
    ...named,
    measure(facts) {
      const topic = topicOf(facts);
      if (topic === undefined || topic.numbers.length < 2) return NOTHING;
      const spans = [0, 1].map((index) => (topic.high[index] ?? 0) - (topic.low[index] ?? 0));
      return {
        passed: spans.every((found) => found >= span),
        value: spans.map(part).join(' × '),
      };
    },
  };
}

/** Requires that no records arrive any more, and the newest value is still there. */
export function valueStays(topicOf: TopicOf, named: Named): Check {
  return {
    ...named,
    measure(facts) {
      const topic = topicOf(facts);
      if (topic === undefined || topic.numbers.length === 0) return NOTHING;
      const value = `${hertz(topic.hz)}, value ${topic.numbers.map(part).join(' ')}`;
      return { passed: topic.hz === 0, value };
    },
  };
}

/** Requires a number of topics with a value. */
export function topicsHoldValues(end: string, count: number, named: Named): Check {
  return {
    ...named,
    measure(facts) {
      const found = topicsThatEnd(facts, end).filter(({ numbers }) => numbers.length > 0);
      if (found.length === 0) return NOTHING;
      return { passed: found.length >= count, value: `${found.length} of ${count}` };
    },
  };
}

/** Requires a newest value. */
export function valueIs(topicOf: TopicOf, wanted: number, named: Named): Check {
  return {
    ...named,
    measure(facts) {
      const [number] = topicOf(facts)?.numbers ?? [];
      if (number === undefined) return NOTHING;
      return { passed: number === wanted, value: String(number) };
    },
  };
}

/** Requires a value whose first number is at least `least`. */
export function valueAtLeast(topicOf: TopicOf, least: number, named: Named): Check {
  return {
    ...named,
    measure(facts) {
      const [number] = topicOf(facts)?.numbers ?? [];
      if (number === undefined) return NOTHING;
      return { passed: number >= least, value: String(number) };
    },
  };
}

/** Requires that the first numbers of two topics add up to 1. */
export function valuesMirror(first: TopicOf, second: TopicOf, named: Named): Check {
  return {
    ...named,
    measure(facts) {
      const [a] = first(facts)?.numbers ?? [];
      const [b] = second(facts)?.numbers ?? [];
      if (a === undefined || b === undefined) return NOTHING;
      // In the middle of the surface, mirrored and plain values are equal.
      const isTelling = Math.abs(a - 0.5) > 0.05;
      return {
        passed: isTelling && Math.abs(a + b - 1) < 0.01,
        value: `${part(a)} + ${part(b)} = ${part(a + b)}`,
      };
    },
  };
}

export function sessionRuns(named: Named): Check {
  return {
    ...named,
    measure({ session }) {
      if (session === undefined) return NOTHING;
      return { passed: session.isRunning, value: session.state };
    },
  };
}

/** Requires that a module of the session runs at a minimum rate. */
export function moduleRuns(module: string, minPerSecond: number, named: Named): Check {
  return {
    ...named,
    measure({ session }) {
      const runs = session?.runsPerSecond.get(module);
      if (runs === undefined) return NOTHING;
      return { passed: runs >= minPerSecond, value: `${perSecond(runs)} runs/s` };
    },
  };
}

/** Requires a number of runs of the try-out in its mode. */
export function tryRuns(minRuns: number, named: Named): Check {
  return {
    ...named,
    measure({ tried }) {
      if (tried === undefined || tried.runs === 0) return NOTHING;
      return {
        passed: tried.isRunning && tried.runs >= minRuns,
        value: `${perSecond(tried.runsPerSecond)} runs/s`,
      };
    },
  };
}

/** Requires that the try-out reads its first input from a topic that is updated. */
export function tryIsFed(minHz: number, named: Named): Check {
  return {
    ...named,
    measure({ tried, topics }) {
      if (tried?.inputTopic === undefined) return NOTHING;
      const { hz } = topics.get(tried.inputTopic) ?? { hz: 0 };
      return { passed: tried.isRunning && hz >= minHz, value: hertz(hz) };
    },
  };
}

/** Requires the newest output of the try-out to be within bounds. */
export function outputWithin(min: number, max: number, named: Named): Check {
  return {
    ...named,
    measure({ tried }) {
      const newest = tried?.series.at(-1);
      if (tried === undefined || newest === undefined) return NOTHING;
      return {
        passed: tried.isRunning && newest >= min && newest <= max,
        value: newest.toFixed(3),
      };
    },
  };
}

/**
 * Length of the longest series of values that each keep about the same share of the previous one: an exponential decay.
 */
export function longestDecay(series: readonly number[], least = 0.3, most = 0.97): number {
  let longest = 0;
  let now = 0;
  for (let index = 1; index < series.length; index += 1) {
    const share = (series[index] ?? 0) / (series[index - 1] ?? 0);
    now = share >= least && share <= most ? now + 1 : 0;
    longest = Math.max(longest, now);
  }
  return longest;
}

/** Requires that the output decays over several runs. */
export function outputDecays(minRuns: number, named: Named): Check {
  return {
    ...named,
    measure({ tried }) {
      if (tried === undefined || tried.series.length === 0) return NOTHING;
      const runs = longestDecay(tried.series);
      return { passed: tried.isRunning && runs >= minRuns, value: `over ${runs} runs` };
    },
  };
}

/** Requires a call of a service with a certain reply. */
export function serviceReplied(
  service: ServiceName,
  read: (call: CallFact, facts: LessonFacts) => string | undefined,
  named: Named,
): Check {
  return {
    ...named,
    measure(facts) {
      const call = facts.calls.find((one) => one.service === service);
      if (call === undefined) return NOTHING;
      if (call.reply === undefined) return { passed: false, value: call.errorCode ?? 'no reply' };
      const value = read(call, facts);
      return { passed: value !== undefined, value: value ?? 'another reply' };
    },
  };
}

/** Requires that a service refused a call with an error code. */
export function serviceRefused(service: ServiceName, code: string, named: Named): Check {
  return {
    ...named,
    measure({ calls }) {
      const call = calls.find((one) => one.service === service);
      if (call === undefined) return NOTHING;
      return { passed: call.errorCode === code, value: call.errorCode ?? 'replied' };
    },
  };
}

/** Requires that a client with a name is connected, or is no longer connected. */
export function clientIs(name: string, isHere: boolean, named: Named): Check {
  return {
    ...named,
    measure({ clientNames }) {
      const count = clientNames.filter((other) => other === name).length;
      if (isHere && count === 0) return NOTHING;
      return {
        passed: isHere ? count > 0 : count === 0,
        value: count === 0 ? 'not connected' : plural(count, 'connected', `${count} connected`),
      };
    },
  };
}
