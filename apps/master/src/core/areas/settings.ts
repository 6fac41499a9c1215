import type { PatternCompiler } from '@ubii/patterns';
import type { AssetStore, SandboxFactory } from '@ubii/pm-sandbox';
import type {
  FlightRecorderSettings,
  Init,
  MasterAddress,
  ProcessingModule,
  SettingList,
} from '@ubii/proto';
import type { PreciseClock } from '@ubii/timing';
import type { AssetSets } from '../ports/asset-sets.ts';
import type { AuditStore } from '../ports/audit-store.ts';
import type { AccessSecrets } from '../ports/access-secrets.ts';
import type { ClusterBus } from '../ports/cluster-bus.ts';
import type { MessageSeal } from '../ports/message-seal.ts';
import type { OwnerStore } from '../ports/owner-store.ts';
import type { DocumentStore, SessionStorage, StudyStorage } from '../ports/document-store.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { Lan } from '../ports/lan.ts';
import type { Log } from '../ports/log.ts';
import type { Recorder } from '@ubii/recording/recorder';
import type { ReplayFiles } from '../ports/replay-files.ts';
import type { ResourceUsage } from '../ports/resource-usage.ts';
import type { ResumeTokens } from '../ports/resume-tokens.ts';
import type { CheckSettings } from '../checks/check-settings.ts';
import type { Limits } from '../limits/index.ts';
import type { LogTail } from '../counters/log-tail.ts';

/** Ports and settings that the core needs. */
export interface MasterPorts {
  readonly clock: PreciseClock;
  readonly ids: IdSource;
  readonly tokens: ResumeTokens;
  readonly accessSecrets: AccessSecrets;
  /** Store of the invitations, readable by the master alone [AC-19]. */
  readonly grants: DocumentStore;
  /** Labels of personal data. [PD-3] */
  readonly personalData: DocumentStore;
  /** Stores of studies and of their runs, by id, readable by the master alone [ST-1]. */
  readonly studyStorage: StudyStorage;
  /** Storage of the audit log. [EX-92] */
  readonly audit: AuditStore;
  readonly log: Log;
  /** Keeps the last lines of `log`, and of what else the process logs [EX-37]. */
  readonly logTail: LogTail;
  readonly patterns: PatternCompiler;
  readonly usage: ResourceUsage;
  /** Opens the master to the local network while it runs [AC-47]. */
  readonly lan: Lan;
  /** Sandboxes for modules on the master. Opened for the first module; closed by the core. */
  readonly sandboxes: SandboxFactory;
  /** Asset sets of trusted modules on the master [PM-90]. Default: none. */
  readonly assets?: AssetStore;
  /** Available asset sets, and downloads of further ones. [EX-57] [EX-58] */
  readonly assetSets: AssetSets;
  readonly storage: SessionStorage;
  /** Writes recordings; the core closes it. */
  readonly recorder: Recorder;
  /** Reads recordings to be played; the core closes it. */
  readonly replayFiles: ReplayFiles;
  /** The other masters of the cluster. Default: this master is alone. [CU-1] */
  readonly cluster?: ClusterPorts;
  /** Trusted modules: those that came with the program, and the operator's [PM-51]. The same list as long as nothing changes. */
  readonly library: () => readonly ProcessingModule[];
}

/** How the masters of a cluster reach each other. */
export interface ClusterPorts {
  readonly name: string;
  readonly bus: ClusterBus;
  readonly seal: MessageSeal;
  readonly owners: OwnerStore;
}

/** Addresses of this master. */
export interface MasterEndpoints {
  /** IPv4 address on a cable; empty when there is none, or when the master listens on loopback only. */
  readonly ipEthernet: string;
  /** IPv4 address on Wi-Fi; empty when there is none, or when the master listens on loopback only. */
  readonly ipWlan: string;
  /** Port for services over HTTP, for existing clients. */
  readonly portServices: number;
  /** Port for topic data over WebSocket, for existing clients. */
  readonly portTopicData: number;
  /** Ports for services and topic data over ZeroMQ; 0 when there are none. */
  readonly portServicesZmq: number;
  readonly portTopicDataZmq: number;
  /** Every address, best first, for people (`MasterStatus.addresses`). */
  readonly addresses: readonly Init<MasterAddress>[];
}

/** Settings of a master. */
export interface MasterSettings {
  /** Name shown to clients. Default `master-node`, as the original calls itself. */
  readonly name?: string;
  /** Tells this installation apart from others of its cluster, the same in later runs. Default: empty. */
  readonly installation?: string;
  /** Version of the master, semantic versioning. */
  readonly version: string;
  /** Asked again for each reply: ports are known only once the master listens, networks come and go. */
  readonly endpoints: () => MasterEndpoints;
  /** Names of the libraries that trusted modules find in `state.modules`. Default: none. */
  readonly libraries?: readonly string[];
  /** Number of modules that this master accepts at once. Default: 100. */
  readonly capacity?: number;
  /** Check settings that differ from `DEFAULT_CHECKS` [EX-48]. */
  readonly checks?: Partial<CheckSettings>;
  /** What the flight recorder keeps, as far as it differs from `DEFAULT_FLIGHT_RECORDER` [RC-30]. */
  readonly flightRecorder?: Partial<FlightRecorderSettings>;
  /** Start options of the program, for people, without secrets [EX-50]. Default: none. */
  readonly startedWith?: Init<SettingList>;
  /** Limits that differ from `DEFAULT_LIMITS`. */
  readonly limits?: Partial<Limits>;
}

/** The name a master shows, chosen or not. */
export function nameOf(settings: MasterSettings): string {
  return settings.name ?? 'master-node';
}
