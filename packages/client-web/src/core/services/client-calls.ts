import { ServiceError } from '@ubii/proto';
import type { Init, ServiceName, ServiceReplyOf, ServiceRequestOf } from '@ubii/proto';
import { within, type Clock } from '@ubii/timing';
import { ConnectionError } from '../connection/connection-error.ts';
import type { Connection } from '../connection/connection.ts';
import { unknownClient } from '../connection/link-failure.ts';
import type { Registration } from '../connection/registration.ts';
import type { ServiceCalls } from './service-calls.ts';

/** Services whose request says on whose behalf it comes. Elsewhere a client id is a criterion. */
const SERVICES_WITH_CLIENT_ID: ReadonlySet<ServiceName> = new Set([
  'topicSubscription',
  'deviceRegistration',
  'deviceDeregistration',
  'clientRename',
  'clientDisconnect',
  'clientThrottle',
  'accessGrantCreate',
  'accessGrantRevoke',
]);

/** Dependencies of the service calls of a client. */
export interface ClientCallsOptions {
  readonly calls: ServiceCalls;
  readonly clock: Clock;
  /** Timeout of a call, including the wait for the connection, milliseconds. */
  readonly timeoutMs: number;
  readonly connection: () => Pick<Connection, 'state' | 'whenConnected'>;
  readonly registration: Pick<Registration, 'clientId' | 'membership' | 'isKnown'>;
}

/** Services called by this client, with its id in requests that name their sender. */
export class ClientCalls {
  readonly #options: ClientCallsOptions;

  constructor(options: ClientCallsOptions) {
    this.#options = options;
  }

  /** Whether the master is, or was when last met, one of ours. */
  get isExtended(): boolean {
    return this.#options.registration.membership?.isExtended ?? true;
  }

  /** Calls a service once there is a connection; waiting for it is part of the time-out. */
  async call<S extends ServiceName>(
    service: S,
    request: Init<ServiceRequestOf<S>> | undefined,
  ): Promise<ServiceReplyOf<S>> {
    const { clock, timeoutMs } = this.#options;
    const connection = this.#options.connection();
    const deadlineMs = clock.monotonicMs() + timeoutMs;
    if (connection.state.status !== 'connected') {
      if (!(await within(clock, timeoutMs, connection.whenConnected()))) {
        throw new ConnectionError(
          'timeout',
          `Expected a connection for "${service}" within ${timeoutMs} ms`,
        );
      }
    }
    return this.callNow(service, request, Math.max(0, deadlineMs - clock.monotonicMs()));
  }

  /** Calls without waiting for the connection: what makes the connection uses this. */
  callNow<S extends ServiceName>(
    service: S,
    request: Init<ServiceRequestOf<S>> | undefined,
    timeoutMs = this.#options.timeoutMs,
  ): Promise<ServiceReplyOf<S>> {
    return this.#options.calls.call(service, this.#withClientId(service, request), timeoutMs);
  }

  /** Calls a service that fails for a client the master does not know, and makes sure to tell that apart. */
  async callAsMember<S extends ServiceName>(
    service: S,
    request: Init<ServiceRequestOf<S>>,
  ): Promise<ServiceReplyOf<S>> {
    try {
      return await this.callNow(service, request);
    } catch (error) {
      if (!(error instanceof ServiceError) || this.isExtended) throw error;
      throw (await this.#options.registration.isKnown()) ? error : unknownClient(error);
    }
  }

  #withClientId<R>(service: ServiceName, request: R): R {
    if (!SERVICES_WITH_CLIENT_ID.has(service) || typeof request !== 'object') return request;
    const { clientId } = request as { clientId?: string };
    return clientId ? request : { ...request, clientId: this.#options.registration.clientId };
  }
}
