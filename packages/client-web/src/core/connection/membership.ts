import type { Init, Mark, NodeExtension, ProcessingModule } from '@ubii/proto';
import type { Identity } from './identity.ts';
import type { ClientRole } from './join.ts';

/** Facts about the client that the master receives. */
export interface ClientProfile {
  readonly name: string;
  readonly description: string;
  readonly tags: readonly string[];
  /** `undefined` when it runs no modules. [PM-60] */
  readonly node: Init<NodeExtension> | undefined;
  readonly processingModules: readonly Init<ProcessingModule>[];
  readonly isDedicatedNode: boolean;
  /** The mark that it would have, or that the master gave it; `undefined` when any will do. [EX-100] */
  readonly mark: Init<Mark> | undefined;
}

/** Result of a registration. */
export interface Membership {
  readonly identity: Identity;
  /** Whether the master is one of ours and speaks the extension. [EX-1] */
  readonly isExtended: boolean;
  /** Whether it tells its time. [TS-1] */
  readonly tellsTime: boolean;
  /** Semantic version; `undefined` for an original master. */
  readonly masterVersion: string | undefined;
  /** Addresses of the other masters of its cluster, as told. [CU-26] */
  readonly masters: readonly string[];
  /** Whether the master belongs to a cluster, in which others may appear. [CU-80] */
  readonly isInCluster: boolean;
  /** Role of the client; `undefined` on masters without roles. [AC-20] */
  readonly role: ClientRole | undefined;
  /** Another number after each registration with which the master may have lost what it knew of us. */
  readonly serial: number;
}
