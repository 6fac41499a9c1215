import { SampledTopic } from './sampler.ts';
import type {
  Receiver,
  Sample,
  Subscriber,
  Targets,
  TopicEntry,
  TopicSampler,
} from './topic-entry.ts';

/** Subscribers that receive the records of this topic by the matching subscriptions, with their rates in Hz (0: every record). */
export function ratesBySubscriber(
  entry: TopicEntry,
  watchers: Iterable<Subscriber>,
): Map<Subscriber, number> {
  const rates = new Map<Subscriber, number>();
  const add = (subscriber: Subscriber, rateHz: number): void => {
    if (entry.isExtension && !subscriber.isExtension) return; // [TD-26]
    if (subscriber.readRights?.mayRead(entry.topic) === false) return; // [AC-25]
    const other = rates.get(subscriber);
    if (other === undefined) rates.set(subscriber, rateHz);
    else rates.set(subscriber, other === 0 || rateHz === 0 ? 0 : Math.max(other, rateHz)); // [TD-28]
  };
  for (const [subscriber, rateHz] of entry.subscribers) add(subscriber, rateHz);
  for (const { subscribers } of entry.patterns) {
    for (const [subscriber, rateHz] of subscribers) add(subscriber, rateHz);
  }
  for (const { subscribers } of entry.selections) {
    for (const [subscriber, rateHz] of subscribers) add(subscriber, rateHz);
  }
  for (const subscriber of watchers) add(subscriber, 0);
  return rates;
}

/** Computes the subscribers of this topic. */
export function computeTargets(entry: TopicEntry, watchers: Iterable<Subscriber>): Targets {
  const direct: Receiver[] = [];
  const sampled: Sample[] = [];
  const rates = ratesBySubscriber(entry, watchers);
  const peers = [...rates].filter(([{ isPeer }]) => isPeer);
  for (const [peer] of peers) rates.delete(peer);
  const before = new Map<TopicSampler, Sample>();
  for (const sample of entry.targets?.sampled ?? []) before.set(sample.sampler, sample);
  const add = ({ outbox, sampler }: Subscriber, rateHz: number): void => {
    if (sampler === undefined) {
      direct.push(outbox);
      return;
    }
    const sample = before.get(sampler);
    before.delete(sampler);
    if (rateHz === 0) {
      direct.push(outbox);
      sample?.release();
    } else {
      const kept = sample ?? new SampledTopic(entry, sampler);
      kept.intervalMs = 1000 / rateHz;
      sampled.push(kept);
    }
  };
  for (const [subscriber, rateHz] of rates) add(subscriber, rateHz);
  const ownDirect = direct.length;
  const ownSampled = sampled.length;
  for (const [peer, rateHz] of peers) add(peer, rateHz);
  for (const sample of before.values()) sample.cancel();
  return { direct, sampled, ownDirect, ownSampled };
}
