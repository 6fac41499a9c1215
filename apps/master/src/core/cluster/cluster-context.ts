import type { InfoTopics } from '../info/info-topics.ts';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { ClusterBus } from '../ports/cluster-bus.ts';
import type { MessageSeal } from '../ports/message-seal.ts';
import type { NodeReports } from '../sessions/node-reports.ts';
import type { SessionNews } from '../sessions/session-news.ts';
import type { Answer } from './calls.ts';
import type { DirectoryContext } from './directory.ts';
import type { OwnMember } from './members.ts';
import type { InterestContext } from './own-interest.ts';
import type { PeerContext } from './peer-subscriber.ts';
import type { MirrorContext } from './session-mirror.ts';
import type { TakeoverContext } from './takeover.ts';
import type { ToldContext } from './told-records.ts';

/** Dependencies of a cluster. */
export interface ClusterContext
  extends
    Omit<PeerContext, 'bus'>,
    ToldContext,
    Omit<DirectoryContext, 'log' | 'grants'>,
    InterestContext,
    Omit<MirrorContext, 'publisher' | 'isThere'>,
    Omit<TakeoverContext, 'grants'> {
  readonly grants: DirectoryContext['grants'] & TakeoverContext['grants'];
  readonly info: Pick<InfoTopics, 'onClient' | 'onClientGone'>;
  readonly publisher: Pick<MasterPublisher, 'publish' | 'publishChange'>;
  readonly onSessionNews: SessionNews['onNews'];
  readonly reports: Pick<NodeReports, 'handleMessage' | 'onBytes'>;
  readonly subscriptions: PeerContext['subscriptions'];
  readonly bus: ClusterBus;
  readonly seal: MessageSeal;
  /** Name of the cluster. */
  readonly name: string;
  readonly self: () => OwnMember;
  /** Answers requests of other masters for their clients. [CU-28] */
  readonly answer: Answer;
}
