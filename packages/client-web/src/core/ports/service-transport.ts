import type { Init, MessageTypes } from '@ubii/proto';

type ServiceRequest = MessageTypes['ubii.services.ServiceRequest'];
type ServiceReply = MessageTypes['ubii.services.ServiceReply'];

/** One service request under way. */
export interface ServiceExchange {
  /**
   * The master's reply, which may be an `error` reply.
   * Rejects with a `ConnectionError`: `refused` when the master cannot be reached or answers with
   * a status other than 200, `protocol` when the answer is not a reply, `closed` after `cancel()`.
   */
  readonly reply: Promise<ServiceReply>;
  /** Gives up waiting. The master may have handled the request anyway. */
  cancel(): void;
}

/** Carries service requests to one master. Keeps no state between requests and sets no time limit. */
export interface ServiceTransport {
  /**
   * Sends one request. Never throws; failures reject `reply`.
   * @param bearer secret that identifies the caller: a token, code or credential [AC-13]
   */
  send(request: Init<ServiceRequest>, bearer?: string): ServiceExchange;
}
