import { EndOfTurn } from '@ubii/timing';
import { MasterPublisher } from '../info/master-publisher.ts';
import { Accounts } from '../shares/accounts.ts';
import { ExpiringValues } from '../topics/expiring-values.ts';
import { KeptValues } from '../topics/kept-values.ts';
import { PatternTable } from '../topics/pattern-table.ts';
import { RecordTap } from '../topics/record-tap.ts';
import { RecordedSources } from '../topics/recorded-sources.ts';
import { ReplayedTopics } from '../topics/replayed-topics.ts';
import { SelectionTable } from '../topics/selection-table.ts';
import { subscriberFactory } from '../topics/subscriber-factory.ts';
import { SubscriptionTable } from '../topics/subscription-table.ts';
import { TopicTable } from '../topics/topic-table.ts';
import { TurnBatches } from '../topics/turn-batches.ts';
import type { Foundation } from './foundation.ts';
import type { MasterPorts } from './settings.ts';

/** Topics with their subscribers, and the accounts that pay for them. */
export type TopicArea = ReturnType<typeof createTopics>;

export type TopicAreaContext = Pick<MasterPorts, 'clock' | 'patterns'> &
  Pick<Foundation, 'startedMs' | 'limits' | 'limitWatch' | 'counters' | 'onClose'>;

export function createTopics(context: TopicAreaContext) {
  const { clock, patterns: compiler, limits, limitWatch, counters } = context;
  const accounts = new Accounts({ clock, limits: limitWatch });
  const patterns = new PatternTable({ clock, compiler });
  const selections = new SelectionTable();
  const topics = new TopicTable(
    [patterns, selections],
    // A thousand epochs fit into each millisecond that earlier runs of the master lasted.
    context.startedMs * 1000,
    limits.keptRemovals,
    accounts.master,
  );
  const subscriptions = new SubscriptionTable({
    topics,
    patterns,
    selections,
    limits: limitWatch,
    accounts,
  });
  const kept = new KeptValues({ clock, limits, topics, accounts });
  const tap = new RecordTap();
  const replayed = new ReplayedTopics();
  const batches = new TurnBatches();
  const endOfTurn = new EndOfTurn(clock, () => batches.renew());
  const expiring = new ExpiringValues({ clock, topics });

  accounts.onShortage.add((shortage, hasRoom) => kept.makeRoom(shortage, hasRoom));
  patterns.onOverdrawn.add((subscriber) => {
    limitWatch.count('patternMatchMs', subscriber.clientId);
    subscriptions.unsubscribePatterns(subscriber);
  });
  context.onClose.add(() => expiring.close());
  return {
    accounts,
    topics,
    kept,
    /** Where records are picked up to be recorded. */
    tap,
    /** Topics that replays play. */
    replayed,
    /** Publishers of what sessions read that run again. */
    recordedSources: new RecordedSources(),
    patternTable: patterns,
    selectionTable: selections,
    subscriptions,
    endOfTurn,
    createSubscriber: subscriberFactory({ clock, limits, counters, endOfTurn, batches, topics }),
    publisher: new MasterPublisher(
      { topics, limits, accounts, counters, kept, tap, replayed },
      clock,
    ),
  };
}
