import {
  ServiceError,
  type Init,
  type NodeRecorderAnswer,
  type NodeRecorderOrder,
} from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import type { Cancel, Clock } from '@ubii/timing';
import type { ClientRegistry } from '../clients/client-registry.ts';
import { quote } from '../texts/quote.ts';

/** Longest time until a node answers, milliseconds: below that of a service. */
const ANSWER_MS = 5_000;
/** Orders that wait for one node. */
const MAX_WAITING = 100;

type Order = Omit<Init<NodeRecorderOrder>, 'number'>;

interface Waiting {
  readonly nodeId: string;
  readonly cancel: Cancel;
  resolve(answer: NodeRecorderAnswer): void;
  reject(error: ServiceError): void;
}

/** What nodes are asked to do for recordings, and their answers. [RC-61] */
export class NodeOrders {
  readonly #clients: ClientRegistry;
  readonly #clock: Clock;
  readonly #waiting = new Map<number, Waiting>();
  #number = 0;

  constructor({ clients, clock }: { readonly clients: ClientRegistry; readonly clock: Clock }) {
    this.#clients = clients;
    this.#clock = clock;
  }

  /** Tells a node something, if it is there. */
  tell(nodeId: string, order: Order): void {
    this.#send(nodeId, { ...order, number: 0 });
  }

  /** @throws ServiceError when the node refuses, does not answer or is not connected */
  ask(nodeId: string, order: Order): Promise<NodeRecorderAnswer> {
    const label = quote(this.#clients.get(nodeId)?.label ?? nodeId);
    const ofNode = [...this.#waiting.values()].filter((each) => each.nodeId === nodeId);
    if (ofNode.length >= MAX_WAITING) {
      const text = `The node ${label} has not answered ${MAX_WAITING} requests. Try again later.`;
      return Promise.reject(new ServiceError('resource_exhausted', text));
    }
    const number = ++this.#number;
    return new Promise((resolve, reject) => {
      const cancel = this.#clock.after(ANSWER_MS, () => {
        this.#waiting.delete(number);
        const text = `The node ${label} did not answer within ${ANSWER_MS / 1000} s. Try again, or restart the node.`;
        reject(new ServiceError('unavailable', text));
      });
      this.#waiting.set(number, { nodeId, cancel, resolve, reject });
      if (!this.#send(nodeId, { ...order, number })) this.handleGone(nodeId, label);
    });
  }

  handleAnswer(nodeId: string, answer: NodeRecorderAnswer): void {
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
      waiting.reject(isAway(label));
    }
  }

  close(): void {
    for (const { cancel } of this.#waiting.values()) cancel();
    this.#waiting.clear();
  }

  #send(nodeId: string, recorderOrder: Init<NodeRecorderOrder>): boolean {
    const socket = this.#clients.get(nodeId)?.socket;
    socket?.sendFrame(encodeNodeMessageFrame({ recorderOrder }));
    return socket !== undefined;
  }
}

/** @param label name of the node, in quotes */
export function isAway(label: string): ServiceError {
  return new ServiceError(
    'unavailable',
    `The node ${label} is not connected. Start it, or try again when it has returned.`,
  );
}
