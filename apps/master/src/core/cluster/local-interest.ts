import type { ClusterInterest, Init } from '@ubii/proto';
import type { EndOfTurn, TurnTask } from '@ubii/timing';
import { Hook } from '../hooks/hook.ts';
import { isSharedTopic } from '../topics/topic-names.ts';
import type { SubscriptionChange, SubscriptionTable } from '../topics/subscription-table.ts';
import type { Subscriber } from '../topics/topic-entry.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import { interestKey } from './interest-key.ts';

/** Dependencies of the interest of this master. */
export interface InterestContext {
  readonly topics: TopicTable;
  readonly subscriptions: Pick<SubscriptionTable, 'onChange'>;
  readonly endOfTurn: EndOfTurn;
}

type Interest = Omit<ClusterInterest, 'maxRateHz'>;

interface Wanted {
  readonly interest: Init<ClusterInterest>;
  readonly rateHz: number;
}

const NOTHING: Interest = { topic: '', pattern: '', profile: undefined, everything: false };

/** What subscribers of this master need from others, each entry once. Sends changes at the end of the turn. [CU-10] */
export class LocalInterest implements TurnTask {
  /** Something is wanted, or at another rate, or not any more. */
  readonly onChange = new Hook<
    [wanted: readonly Init<ClusterInterest>[], unwanted: readonly Init<ClusterInterest>[]]
  >();
  readonly #context: InterestContext;
  readonly #wanted = new Map<string, Wanted>();
  readonly #changed = new Map<string, SubscriptionChange>();

  constructor(context: InterestContext) {
    this.#context = context;
    context.subscriptions.onChange.add((changed) => this.#handleChange(changed));
  }

  /** All that is wanted now. */
  list(): Init<ClusterInterest>[] {
    return [...this.#wanted.values()].map(({ interest }) => interest);
  }

  handleEndOfTurn(): void {
    const wanted: Init<ClusterInterest>[] = [];
    const unwanted: Init<ClusterInterest>[] = [];
    for (const [key, changed] of this.#changed) {
      const before = this.#wanted.get(key);
      const rateHz = this.#rateOf(changed);
      if (rateHz === before?.rateHz) continue;
      if (rateHz === undefined) {
        this.#wanted.delete(key);
        unwanted.push(before!.interest);
      } else {
        const interest = { ...interestOf(changed), maxRateHz: rateHz };
        this.#wanted.set(key, { interest, rateHz });
        wanted.push(interest);
      }
    }
    this.#changed.clear();
    if (wanted.length + unwanted.length > 0) this.onChange.emit(wanted, unwanted);
  }

  #handleChange(changed: SubscriptionChange): void {
    if (changed !== 'everything' && 'topic' in changed && !isSharedTopic(changed.topic)) return; // [CU-16]
    const key = interestKey(interestOf(changed));
    if (this.#changed.size === 0) this.#context.endOfTurn.add(this);
    this.#changed.set(key, changed);
  }

  /** Rate that satisfies every subscriber of this master, 0 for every record; undefined without one. */
  #rateOf(changed: SubscriptionChange): number | undefined {
    if (changed === 'everything') return this.#context.topics.isWatched ? 0 : undefined;
    return rateFor(changed.subscribers);
  }
}

function rateFor(subscribers: ReadonlyMap<Subscriber, number>): number | undefined {
  let most: number | undefined = undefined;
  for (const [{ isPeer, sampler }, rateHz] of subscribers) {
    if (isPeer) continue;
    if (rateHz === 0 || sampler === undefined) return 0;
    most = Math.max(most ?? 0, rateHz);
  }
  return most;
}

function interestOf(changed: SubscriptionChange): Interest {
  if (changed === 'everything') return { ...NOTHING, everything: true };
  if ('source' in changed) return { ...NOTHING, pattern: changed.source };
  if ('profile' in changed) return { ...NOTHING, profile: changed.profile };
  return { ...NOTHING, topic: changed.topic };
}
