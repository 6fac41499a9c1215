import { ServiceError, type ErrorMessage } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import type { ClientRegistry } from '../clients/client-registry.ts';
import { quote } from '../texts/quote.ts';

/** Longest time until a node answers, milliseconds: below that of a service. */
const ANSWER_MS = 5_000;
/** Requests that wait for one node. */
const MAX_WAITING = 100;

/** The least that an answer of a node has. */
interface NumberedAnswer {
  readonly number: number;
  readonly error?: ErrorMessage | undefined;
}

/** Arguments of `NodeRequests`. */
export interface NodeRequestsContext {
  readonly clients: ClientRegistry;
  readonly clock: Clock;
}

/** How requests of one kind travel. */
export interface NodeRequestKind<O> {
  /** What asks are sent to, for messages: "node". */
  readonly noun: string;
  /** @param number 0 when no answer is expected */
  encodeFrame(order: O, number: number): Uint8Array;
  /** Default: `MAX_WAITING`. */
  readonly maxWaiting?: number;
}

interface Waiting<A> {
  readonly nodeId: string;
  readonly cancel: Cancel;
  resolve(answer: A): void;
  reject(error: ServiceError): void;
}

/** Requests of the master to nodes in node messages, and their answers. [EX-20] */
export class NodeRequests<O, A extends NumberedAnswer> {
  readonly #context: NodeRequestsContext;
  readonly #kind: NodeRequestKind<O>;
  readonly #waiting = new Map<number, Waiting<A>>();
  #number = 0;

  constructor(context: NodeRequestsContext, kind: NodeRequestKind<O>) {
    this.#context = context;
    this.#kind = kind;
  }

  /** Tells a node something, if it is there. */
  send(nodeId: string, order: O): void {
    this.#send(nodeId, order, 0);
  }

  /** @throws ServiceError when the node refuses, does not answer or is not connected */
  ask(nodeId: string, order: O): Promise<A> {
    const { clients, clock } = this.#context;
    const { noun, maxWaiting = MAX_WAITING } = this.#kind;
    const label = quote(clients.get(nodeId)?.label ?? nodeId);
    const ofNode = [...this.#waiting.values()].filter((each) => each.nodeId === nodeId);
    if (ofNode.length >= maxWaiting) {
      const text = `The ${noun} ${label} has not answered ${maxWaiting} requests. Try again later.`;
      return Promise.reject(new ServiceError('resource_exhausted', text));
    }
    const number = ++this.#number;
    return new Promise((resolve, reject) => {
      const cancel = clock.after(ANSWER_MS, () => {
        this.#waiting.delete(number);
        const text = `The ${noun} ${label} did not answer within ${ANSWER_MS / 1000} s. Try again, or restart the ${noun}.`;
        reject(new ServiceError('unavailable', text));
      });
      this.#waiting.set(number, { nodeId, cancel, resolve, reject });
      if (!this.#send(nodeId, order, number)) this.handleGone(nodeId, label);
    });
  }

  handleAnswer(nodeId: string, answer: A): void {
    const waiting = this.#waiting.get(answer.number);
    // No node answers for another.
    if (waiting?.nodeId !== nodeId) return;
    this.#waiting.delete(answer.number);
    waiting.cancel();
    if (answer.error === undefined) waiting.resolve(answer);
    else waiting.reject(ServiceError.fromWire(answer.error));
  }

  /** @param label name of the node, in quotes */
  handleGone(nodeId: string, label: string): void {
    for (const [number, waiting] of this.#waiting) {
      if (waiting.nodeId !== nodeId) continue;
      this.#waiting.delete(number);
      waiting.cancel();
      waiting.reject(isAway(label, this.#kind.noun));
    }
  }

  close(): void {
    for (const { cancel } of this.#waiting.values()) cancel();
    this.#waiting.clear();
  }

  #send(nodeId: string, order: O, number: number): boolean {
    const socket = this.#context.clients.get(nodeId)?.socket;
    socket?.sendFrame(this.#kind.encodeFrame(order, number));
    return socket !== undefined;
  }
}

/** @param label name of the node, in quotes */
export function isAway(label: string, noun = 'node'): ServiceError {
  return new ServiceError(
    'unavailable',
    `The ${noun} ${label} is not connected. Start it, or try again when it has returned.`,
  );
}
