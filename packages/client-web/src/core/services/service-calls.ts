import { SERVICES, ServiceError } from '@ubii/proto';
import type {
  Init,
  ServiceName,
  ServiceReply,
  ServiceReplyOf,
  ServiceRequest,
  ServiceRequestOf,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { ConnectionError } from '../connection/connection-error.ts';
import { Deferred } from '../callbacks/deferred.ts';
import type { ServiceTransport } from '../ports/service-transport.ts';
import { atDeadline } from '../time/deadline.ts';

/** Connections that browsers keep to one origin. */
const KEPT_CONNECTIONS = 6;
/** A connection that works has an answer by then, most likely, milliseconds. */
const FRESH_ANSWER_MS = 700;

/** Calls under way to one master: each is answered, times out, or is rejected by `rejectAll`. */
export class ServiceCalls {
  readonly #transport: ServiceTransport;
  readonly #clock: Clock;
  readonly #timeoutMs: number;
  readonly #bearer: () => string | undefined;
  readonly #open = new Set<(error: ConnectionError) => void>();

  /** @param bearer returns the current secret that identifies the caller [AC-13] */
  constructor(
    transport: ServiceTransport,
    clock: Clock,
    timeoutMs: number,
    bearer: () => string | undefined = () => undefined,
  ) {
    this.#transport = transport;
    this.#clock = clock;
    this.#timeoutMs = timeoutMs;
    this.#bearer = bearer;
  }

  /**
   * Sends one request and gives the payload of the reply.
   * @param bearer in place of the current secret; empty for none
   * @throws {ServiceError} what the master answered
   * @throws {ConnectionError} `timeout`, `refused`, `protocol`, or the error of `rejectAll`
   */
  async call<S extends ServiceName>(
    service: S,
    request: Init<ServiceRequestOf<S>> | undefined,
    timeoutMs = this.#timeoutMs,
    bearer: string | undefined = this.#bearer(),
  ): Promise<ServiceReplyOf<S>> {
    const { topic, request: requestMember, reply: replyMember } = SERVICES[service];
    const message: Init<ServiceRequest> =
      requestMember === undefined || request === undefined
        ? { topic }
        : { topic, [requestMember]: request };
    const reply = await this.#exchange(topic, message, timeoutMs, bearer);
    if (reply.error !== undefined) throw ServiceError.fromWire(reply.error);
    const payload = reply[replyMember];
    if (payload === undefined) {
      throw new ConnectionError(
        'protocol',
        `Expected "${replyMember}" in the reply of "${topic}", received "${Object.keys(reply).join(', ') || 'nothing'}"`,
      );
    }
    return payload as ServiceReplyOf<S>;
  }

  /**
   * Finds the connections that a browser keeps for requests and that lead nowhere since the network went
   * silently: it would take them first. What is not answered soon is cancelled, which closes them. [CL-43]
   */
  freshen(): void {
    for (let i = 0; i < KEPT_CONNECTIONS; i++) {
      this.call('serverConfiguration', undefined, FRESH_ANSWER_MS).catch(() => undefined);
    }
  }

  /** Rejects every open call. Later calls are not affected. */
  rejectAll(error: ConnectionError): void {
    for (const reject of [...this.#open]) reject(error);
  }

  #exchange(
    topic: string,
    message: Init<ServiceRequest>,
    timeoutMs: number,
    bearer: string | undefined,
  ): Promise<ServiceReply> {
    const settled = new Deferred<ServiceReply>();
    const exchange = this.#transport.send(message, bearer === '' ? undefined : bearer);
    const giveUp = (error: ConnectionError): void => {
      finish();
      settled.reject(error);
      exchange.cancel();
    };
    const cancelTimer = atDeadline(this.#clock, timeoutMs, () =>
      giveUp(
        new ConnectionError(
          'timeout',
          `Expected a reply of "${topic}" within ${timeoutMs} ms, received none`,
        ),
      ),
    );
    const finish = (): void => {
      cancelTimer();
      this.#open.delete(giveUp);
    };
    this.#open.add(giveUp);
    exchange.reply.then(
      (reply) => {
        finish();
        settled.resolve(reply);
      },
      (error: unknown) => {
        finish();
        settled.reject(error);
      },
    );
    return settled.promise;
  }
}
