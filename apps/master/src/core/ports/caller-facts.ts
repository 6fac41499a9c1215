/**
 * Kind of the caller, as far as the transport knows it: `trusted`, this machine itself where the operator trusts
 * all of it; `local`, this machine; `network`, one of the networks that are admitted without a token;
 * `other`, everybody else [AC-1] [AC-4] [AC-5] [AC-40].
 */
export type CallerStanding = 'trusted' | 'local' | 'network' | 'other';

/** Another master of the cluster, which a caller has called. [CU-28] */
export interface CalledMaster {
  readonly id: string;
  readonly name: string;
  /** Tells its installation apart from others of the cluster. */
  readonly installation: string;
}

/** Facts that a transport knows about a caller or a connecting client. */
export interface CallerFacts {
  readonly standing: CallerStanding;
  /**
   * The connection comes from this machine without a proxy, whatever page or name it is for: what
   * is only good here may be shown over it [AC-43].
   */
  readonly isHere: boolean;
  /** Unit by which wrong codes are counted: its address, or the network of one user. [AC-17] */
  readonly place: string;
  /** The address itself, where `place` is a network. @default `place` */
  readonly address?: string | undefined;
  /** The token, code or credential that it shows; undefined without one [AC-3]. */
  readonly bearer: string | undefined;
  /** The master that was called, and has judged the connection. Default: this one. */
  readonly calledMaster?: CalledMaster;
}

/** A caller of this machine, without a token. */
export const LOCAL_CALLER: CallerFacts = {
  standing: 'local',
  isHere: true,
  place: 'here',
  bearer: undefined,
};

/** The same, where the operator trusts all of this machine. */
export const TRUSTED_CALLER: CallerFacts = { ...LOCAL_CALLER, standing: 'trusted' };
