import type { TopicRecord } from '@ubii/proto';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { sparkNumbers } from '../../topics/values/value-series.ts';
import { NO_VALUES, withValue, type TopicFact, type ValueRange } from '../model/facts.ts';

/** Interval of requests for rates, milliseconds. */
const RATES_MS = 500;

export interface TopicFacts {
  /** Returns the current state of matching and named topics. */
  read(named: readonly (string | undefined)[]): ReadonlyMap<string, TopicFact>;
  /** Restarts the ranges of values. */
  restart(): void;
}

/**
 * Rates and values of the topics of a lesson, while the calling scope is active.
 * @param globs of topics whose values are recorded
 */
export function useTopicFacts(globs: readonly string[]): TopicFacts {
  const { topics } = useConnection();
  topics.watch(RATES_MS);
  const values = new Map<string, { format: string; range: ValueRange }>();

  function handle(record: TopicRecord): void {
    if (record.format === undefined) return;
    const numbers = sparkNumbers(record.format, record.value);
    const range = values.get(record.topic)?.range ?? NO_VALUES;
    values.set(record.topic, { format: record.format, range: withValue(range, numbers) });
  }
  useTopic(
    globs.map((glob) => ({ glob })),
    { keep: 0, onRecord: handle },
  );

  return {
    read(named) {
      const rates = topics.rates.value;
      const names = [...values.keys(), ...named.filter((name) => name !== undefined)];
      const facts = new Map<string, TopicFact>();
      for (const topic of names) {
        const rate = rates?.get(topic);
        // A topic that the master no longer knows has ended.
        if (rates !== undefined && rate === undefined) continue;
        const value = values.get(topic);
        facts.set(topic, {
          topic,
          format: value?.format ?? rate?.statistic.dataFormat ?? '',
          hz: rate?.hz ?? 0,
          ...(value?.range ?? NO_VALUES),
        });
      }
      return facts;
    },
    restart() {
      for (const [topic, { format, range }] of values) {
        values.set(topic, { format, range: withValue(NO_VALUES, range.numbers) });
      }
    },
  };
}
