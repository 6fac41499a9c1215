import type { Recording, ServiceRequest } from '@ubii/proto';
import type { Role } from '../access/roles.ts';
export type { Role } from '../access/roles.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import type { ConnectionHost } from '../ports/connection-host.ts';
import type { OpenConnection, TransportPeer } from '../connections/open-connection.ts';
import type { NodeUpload, Upload } from '../recordings/recording-uploads.ts';
import type { IncomingRequest } from '../services/incoming-request.ts';
import type { RestoreReport, SessionsAtStop } from '../sessions/restored-sessions.ts';
import type { TerminalAccess } from '../access/terminal-access.ts';
import type { MasterMetrics } from '../monitoring/metric-family.ts';
import type { ServiceAnswer } from '../services/service-answer.ts';
export type { TerminalAccess, TerminalJoin } from '../access/terminal-access.ts';
export type { MasterMetrics, MetricFamily } from '../monitoring/metric-family.ts';
export type { ServiceAnswer } from '../services/service-answer.ts';

/** A master without transports: feed it requests and connections. Nothing a client sends makes a method throw or reject. */
export interface Master extends ConnectionHost {
  /** Id of this run, a UUID: what `server_configuration` and `master_status` show. */
  readonly id: string;
  /**
   * Takes a connection that was just made to one of the ports. [AC-60]
   *
   * @param cut closes it at once; called when there is no room for it any more, or when it says nothing
   * @returns undefined when there is no room: it is to be cut
   */
  admitConnection(peer: TransportPeer, cut: () => void): OpenConnection | undefined;
  /**
   * Begins a request whose headers have come, before its body is read: says what the body may be. [SV-40]
   *
   * @param connection the same object for all requests of a connection
   */
  openRequest(caller: CallerFacts, connection: object): IncomingRequest;
  /**
   * Answers one decoded request; errors are in the reply. Settles within `limits.serviceTimeoutMs`.
   *
   * @param incoming what `openRequest` returned for it, so that a wrong code counts once
   */
  handleServiceRequest(
    request: ServiceRequest,
    caller: CallerFacts,
    incoming?: IncomingRequest,
  ): Promise<ServiceAnswer>;
  /** The reply to a request the edge refused itself: undecodable (pass the `DecodeError`), or with a `ServiceError` of its choice. Counts it (SV-7). */
  refuseServiceRequest(cause: unknown): ServiceAnswer;
  readonly metrics: () => MasterMetrics;
  /** Web addresses of the other masters of the cluster since the start, for adapters with pages. [CU-90] */
  otherMasterAddresses(): readonly string[];
  /** Returns the rights of a caller, for adapters that check access themselves. */
  roleOf(caller: CallerFacts): Role;
  /** Whether this caller shows a token, code or credential that is good for something. */
  recognizes(caller: CallerFacts): boolean;
  /**
   * Makes what the terminal of this run shows, in place of what that of the run before showed [AC-19]
   * [AC-42].
   *
   * @param isReachable whether others than this machine can reach the master
   * @throws Error when it cannot be kept
   */
  openTerminal(isReachable: boolean): Promise<TerminalAccess>;
  /** Returns a recording whose file this caller may read. [RC-40] @throws ServiceError when it may not, or there is none */
  requireRecording(id: string, caller: CallerFacts): Promise<Recording>;
  /** Takes in an uploaded recording. [RC-41] @throws ServiceError when it is too large or no recording */
  uploadRecording(upload: Upload, name: string, caller: CallerFacts): Promise<Recording>;
  /** Takes in the file of a recording that a node made. [RC-63] @throws ServiceError when another caller brings it */
  uploadNodeRecording(upload: NodeUpload, caller: CallerFacts): Promise<Recording>;
  /** Returns which running sessions would restart and which would end if the master stopped now [SE-24]. */
  sessionsAtStop(): SessionsAtStop;
  /** Resolves to the results of the sessions that this master had to restart [SE-24]. */
  sessionsRestored(): Promise<RestoreReport>;
  /** Ends every timer, closes every connection, and ends modules and workers. */
  close(): Promise<void>;
}
