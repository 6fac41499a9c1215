import { createSocket } from 'node:dgram';
import type { RemoteInfo, Socket, SocketType } from 'node:dgram';
import { lookup } from 'node:dns/promises';
import { isIP } from 'node:net';
import type { Clock } from '@ubii/timing';
import { BackOff } from '../../core/back-off.ts';
import type { Mapping } from '../../core/mapping/mapping.ts';
import type {
  ForeignEvents,
  ForeignSystem,
  OutgoingMessage,
  Sent,
} from '../../core/ports/foreign-system.ts';
import type { OscContent } from './osc-codec.ts';
import { addressProblem, decodeOsc, encodeOsc, MAX_DATAGRAM_BYTES } from './osc-messages.ts';

/** How often the address of a computer that has a name is looked up again, milliseconds. [BR-61] */
const LOOK_UP_MS = 60_000;

/** Arguments of `createOscSystem`. */
export interface OscSettings {
  /** Where messages are sent, and the only computer from which they are taken. [BR-61] */
  readonly host: string;
  readonly port: number;
  /** UDP port at which messages are received. @default any free one */
  readonly listen: number | undefined;
  readonly clock: Clock;
  readonly random?: () => number;
  /** @default that of the system */
  readonly lookUp?: (
    host: string,
  ) => Promise<{ readonly address: string; readonly family: number }>;
}

/** A program that speaks OSC 1.0 over UDP. */
export function createOscSystem(settings: OscSettings): OscSystem {
  return new OscSystem(settings);
}

/** @see createOscSystem */
export class OscSystem implements ForeignSystem<OscContent> {
  readonly #settings: OscSettings;
  readonly #backOff: BackOff;
  #events: ForeignEvents<OscContent> | undefined;
  #socket: Socket | undefined;
  #peer = '';
  #cancelRetry: (() => void) | undefined;

  constructor(settings: OscSettings) {
    this.#settings = settings;
    this.#backOff = new BackOff(settings.random ?? Math.random);
  }

  /** The port at which it listens; 0 while it does not. */
  get port(): number {
    return this.#socket?.address().port ?? 0;
  }

  open(events: ForeignEvents<OscContent>): void {
    this.#events = events;
    events.handleState({ status: 'connecting' });
    void this.#begin();
  }

  /** UDP has no subscriptions: all that comes is told, and the engine selects. */
  setMappings(_mappings: readonly Mapping[]): void {
    if (this.#socket !== undefined) this.#events?.handleSettled();
  }

  send({ address, payload, mapping: _mapping }: OutgoingMessage<OscContent>): Sent {
    const socket = this.#socket;
    if (socket === undefined) return { kind: 'dropped', reason: 'The UDP port is not open.' };
    // OSC keeps no values: there is none to delete.
    if (payload === undefined) return { kind: 'sent' };
    const problem = addressProblem(address);
    if (problem !== undefined) return { kind: 'refused', reason: problem };
    const bytes = encodeOsc({ address, ...payload });
    if (bytes.length > MAX_DATAGRAM_BYTES) {
      const reason = `The message has ${bytes.length} bytes; a datagram has at most ${MAX_DATAGRAM_BYTES}.`;
      return { kind: 'refused', reason };
    }
    socket.send(bytes, this.#settings.port, this.#peer, (error) => {
      if (error) this.#events?.handleDropped(_mapping, error.message);
    });
    return { kind: 'sent' };
  }

  setAvailable(_isAvailable: boolean): void {}

  async close(): Promise<void> {
    this.#events = undefined;
    this.#cancelRetry?.();
    const socket = this.#socket;
    this.#socket = undefined;
    if (socket !== undefined) await new Promise<void>((resolve) => socket.close(resolve));
  }

  async #begin(): Promise<void> {
    const { host, listen = 0, clock } = this.#settings;
    try {
      const { address, family } = await this.#lookUp(host);
      const socket = await openSocket(family === 6 ? 'udp6' : 'udp4', listen, loopbackOf(address));
      if (this.#events === undefined) return void socket.close();
      this.#peer = address;
      this.#socket = socket;
      this.#cancelRetry = isIP(host) > 0 ? undefined : this.#followName(address);
      socket.on('message', (bytes, from) => this.#handleDatagram(bytes, from));
      socket.on('error', (error) => this.#events?.handleRefused(error.message));
      this.#backOff.handleConnected();
      this.#events.handleState({ status: 'connected', hasForgotten: false });
      this.#events.handleSettled();
    } catch (error) {
      if (this.#events === undefined) return;
      this.#events.handleState({ status: 'waiting', reason: (error as Error).message });
      this.#cancelRetry = clock.after(this.#backOff.nextMs(), () => void this.#begin());
    }
  }

  get #lookUp(): (host: string) => Promise<{ readonly address: string; readonly family: number }> {
    return this.#settings.lookUp ?? lookup;
  }

  /** A computer may get another address while the bridge runs: then it begins again there. */
  #followName(address: string): () => void {
    const { host, clock } = this.#settings;
    return clock.every(LOOK_UP_MS, () => {
      this.#lookUp(host).then(
        (found) => {
          if (found.address !== address && this.#peer === address) this.#beginAgain(found.address);
        },
        // The name may be known again later; until then, the address stays.
        () => undefined,
      );
    });
  }

  #beginAgain(address: string): void {
    const { host } = this.#settings;
    this.#cancelRetry?.();
    this.#socket?.close();
    this.#socket = undefined;
    if (this.#events === undefined) return;
    this.#events.handleState({ status: 'waiting', reason: `${host} is now at ${address}` });
    void this.#begin();
  }

  #handleDatagram(bytes: Buffer, from: RemoteInfo): void {
    if (from.address !== this.#peer) {
      this.#events?.handleRefused(`${from.address} is not the computer of this bridge.`);
      return;
    }
    try {
      for (const { address, args, timestampMs } of decodeOsc(bytes)) {
        this.#events?.handleMessage({
          address,
          payload: { args, timestampMs },
          sizeBytes: bytes.length,
          isEmpty: false,
          isOurs: false,
          isKept: false,
        });
      }
    } catch (error) {
      this.#events?.handleRefused(`No OSC message: ${(error as Error).message}`);
    }
  }
}

/** A bridge to a program of this computer is not open to others. */
function loopbackOf(address: string): string | undefined {
  return /^(127\.|::1$)/.test(address) ? address : undefined;
}

/** Opens a UDP port. One that cannot be opened leaves no socket. */
function openSocket(type: SocketType, port: number, address: string | undefined): Promise<Socket> {
  const socket = createSocket(type);
  return new Promise((resolve, reject) => {
    const fail = (error: Error): void => {
      socket.close();
      reject(error);
    };
    socket.once('error', fail);
    socket.bind({ port, ...(address !== undefined && { address }) }, () => {
      socket.off('error', fail);
      resolve(socket);
    });
  });
}
