import type { Clock, EndOfTurn } from '@ubii/timing';
import type { Grants } from '../access/grants.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { Counters } from '../counters/counters.ts';
import type { EventLog } from '../counters/event-log.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import type { InfoTopics } from '../info/info-topics.ts';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { Limits } from '../limits/index.ts';
import type { ClusterBus } from '../ports/cluster-bus.ts';
import type { Log } from '../ports/log.ts';
import type { MessageSeal } from '../ports/message-seal.ts';
import type { OwnerStore } from '../ports/owner-store.ts';
import type { ForeignSessions } from '../sessions/foreign-sessions.ts';
import type { NodeReports } from '../sessions/node-reports.ts';
import type { SessionClaims } from '../sessions/session-claims.ts';
import type { SessionLibrary } from '../sessions/session-library.ts';
import type { SessionNews } from '../sessions/session-news.ts';
import type { SessionTable } from '../sessions/session-table.ts';
import type { Sessions } from '../sessions/sessions.ts';
import type { Accounts } from '../shares/accounts.ts';
import type { KeptValues } from '../topics/kept-values.ts';
import type { RecordTap } from '../topics/record-tap.ts';
import type { ReplayedTopics } from '../topics/replayed-topics.ts';
import type { SubscriberFactory } from '../topics/subscriber-factory.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { Answer } from './calls.ts';
import type { OwnMember } from './members.ts';

/** Dependencies of a cluster. */
export interface ClusterContext {
  /** Id of this master. */
  readonly id: string;
  /** Name of the cluster. */
  readonly name: string;
  /** This master, for the others. */
  readonly self: () => OwnMember;
  readonly bus: ClusterBus;
  readonly seal: MessageSeal;
  readonly owners: OwnerStore;
  readonly clock: Clock;
  readonly endOfTurn: EndOfTurn;
  readonly limits: Limits;
  readonly log: Log;
  readonly counters: Counters;
  readonly events: EventLog;
  readonly accounts: Accounts;
  readonly topics: TopicTable;
  readonly subscriptions: SubscriptionTable;
  readonly createSubscriber: SubscriberFactory;
  readonly tap: RecordTap;
  readonly replayed: ReplayedTopics;
  readonly kept: KeptValues;
  readonly clients: ClientRegistry;
  readonly devices: DeviceRegistry;
  readonly grants: Pick<Grants, 'get' | 'isValid'>;
  readonly info: Pick<InfoTopics, 'onClient' | 'onClientGone'>;
  readonly publisher: Pick<MasterPublisher, 'publish' | 'publishChange'>;
  readonly sessions: Sessions;
  readonly sessionTable: SessionTable;
  readonly sessionLibrary: Pick<SessionLibrary, 'rememberUnsaved'>;
  readonly foreignSessions: ForeignSessions;
  readonly claims: SessionClaims;
  readonly onSessionNews: SessionNews['onNews'];
  readonly reports: Pick<NodeReports, 'handleMessage' | 'onBytes'>;
  /** Answers requests of other masters for their clients. [CU-28] */
  readonly answer: Answer;
}
