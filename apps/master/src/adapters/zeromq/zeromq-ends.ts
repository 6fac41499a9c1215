import type { Socket } from 'node:net';

import type { Limits } from '../../core/limits/index.ts';
import type { ConnectionHost } from '../../core/ports/index.ts';
import { ZeroMqServices, type ZeroMqServicesContext } from './zeromq-services.ts';
import { ZeroMqTopicData } from './zeromq-topic-data.ts';

/** What both ends need. */
export interface ZeroMqEndsContext extends Omit<ZeroMqServicesContext, 'greetingMs' | 'replyMs'> {
  readonly master: ConnectionHost & ZeroMqServicesContext['master'];
  readonly limits: ZeroMqServicesContext['limits'] &
    Pick<Limits, 'frameBytes' | 'headersTimeoutMs' | 'slowSocketTimeoutMs'>;
}

/** Services and topic data over ZeroMQ, each on a port of its own. [AC-6] */
export class ZeroMqEnds {
  readonly #services: ZeroMqServices;
  readonly #topicData: ZeroMqTopicData;

  constructor(context: ZeroMqEndsContext) {
    const { frameBytes, headersTimeoutMs, slowSocketTimeoutMs } = context.limits;
    const greetingMs = headersTimeoutMs; // [AC-63]
    this.#services = new ZeroMqServices({ ...context, greetingMs, replyMs: slowSocketTimeoutMs });
    this.#topicData = new ZeroMqTopicData({ ...context, greetingMs, maxMessageBytes: frameBytes });
  }

  /** Takes a connection to the port of the services. */
  readonly services = (socket: Socket): void => this.#services.handleConnection(socket);
  /** Takes a connection to the port of the topic data. */
  readonly topicData = (socket: Socket): void => this.#topicData.handleConnection(socket);

  /** Ends the connections on which nothing is asked. Clients are told by the master. */
  close(): void {
    this.#services.close();
  }

  /** Ends what is still open silently. */
  terminate(): void {
    this.#services.terminate();
    this.#topicData.terminate();
  }
}
