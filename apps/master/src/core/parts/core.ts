import type { Access } from '../access/access.ts';
import type { AuditLog } from '../audit/audit-log.ts';
import type { OverloadChecks } from '../checks/overload-checks.ts';
import type { ClientMeter } from '../clients/client-meter.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { SocketAdmission } from '../clients/socket-admission.ts';
import type { Connections } from '../connections/connections.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import type { InfoTopics } from '../info/info-topics.ts';
import type { Limits } from '../limits/index.ts';
import type { Processing } from './processing.ts';
import type { BodyAccounts } from '../connections/body-accounts.ts';
import type { MasterPorts, MasterSettings } from './settings.ts';
import type { Accounts } from '../shares/accounts.ts';
import type { Counters } from '../counters/counters.ts';
import type { EventLog } from '../counters/event-log.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { Load } from '../counters/load.ts';
import type { Samples } from '../counters/samples.ts';
import type { KeptValues } from '../topics/kept-values.ts';
import type { PatternTable } from '../topics/pattern-table.ts';
import type { SelectionTable } from '../topics/selection-table.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { TopicTable } from '../topics/topic-table.ts';

/** The parts of a master, as services and status work on them. */
export interface Core extends Omit<MasterPorts, 'audit'> {
  readonly id: string;
  readonly startedMs: number;
  readonly settings: MasterSettings;
  readonly limits: Limits;
  readonly access: Access;
  /** Connections to all ports. */
  readonly connections: Connections;
  /** Service requests in flight. */
  readonly bodies: BodyAccounts;
  readonly topics: TopicTable;
  readonly kept: KeptValues;
  readonly patternTable: PatternTable;
  readonly selectionTable: SelectionTable;
  readonly subscriptions: SubscriptionTable;
  readonly clients: ClientRegistry;
  readonly sockets: SocketAdmission;
  readonly devices: DeviceRegistry;
  readonly accounts: Accounts;
  readonly info: InfoTopics;
  readonly processing: Processing;
  readonly counters: Counters;
  readonly limitWatch: LimitWatch;
  readonly events: EventLog;
  /** Actions of admins and participants [EX-90]. */
  readonly audit: AuditLog;
  readonly samples: Samples;
  readonly load: Load;
  readonly checks: OverloadChecks;
  readonly clientMeter: ClientMeter;
}
