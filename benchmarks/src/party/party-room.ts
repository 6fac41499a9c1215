import { createClient, type UbiiClient } from '@ubii/client-web/node';
import type { MasterProcess } from '@ubii/harness';
import type { RoundPlan, RoundSeats, RoundState } from '@ubii/party/modules';
import {
  gameSession,
  phoneTopic,
  ROUND_TOPIC,
  SEATS_TOPIC,
  settingTopic,
  stateTopic,
} from '@ubii/party/net';
import type { HillState } from '@ubii/party/sim';
import { startSession, type RunningSession } from '../modules/running-session.ts';
import type { Part } from '../parts/shared-parts.ts';

const PLAYERS = 32;
/** Phones send so often. */
const SEND_MS = 1000 / 60;

/** A round of King of the Hill on the master, played by 32 clients at 60 Hz, with a spectator. */
export class PartyRoom implements Part {
  readonly #clients: readonly UbiiClient[];
  readonly #session: RunningSession;
  #timer: NodeJS.Timeout | undefined;
  #rounds = 0;
  #seat = 0;
  /** Called for each state. */
  onState: (state: RoundState<HillState>) => void = () => undefined;

  private constructor(clients: readonly UbiiClient[], session: RunningSession) {
    this.#clients = clients;
    this.#session = session;
  }

  static async open(master: MasterProcess): Promise<PartyRoom> {
    const session = await startSession(master, gameSession('hill'));
    const clients = Array.from({ length: PLAYERS + 1 }, (_, index) =>
      createClient({ url: master.url, name: `phone ${index}`, publishIntervalMs: 0 }),
    );
    await Promise.all(clients.map((client) => client.connect()));
    const room = new PartyRoom(clients, session);
    const states = clients[PLAYERS]!.subscribe(stateTopic('hill'), { format: 'string' });
    states.onRecord(({ value }) => room.onState(JSON.parse(value) as RoundState<HillState>));
    await states.ready;
    return room;
  }

  /** The client of the big screen, which only receives. */
  get screen(): UbiiClient {
    return this.#clients[PLAYERS]!;
  }

  get phones(): readonly UbiiClient[] {
    return this.#clients.slice(0, PLAYERS);
  }

  /** Each in turn: a piece that has dashed can charge again after a second and a half. */
  nextSeat(): number {
    this.#seat = (this.#seat + 1) % PLAYERS;
    return this.#seat;
  }

  /** Begins a round now, and keeps all sticks moving. */
  play(): void {
    const seats = this.phones.map((_, seat) => seat);
    const clients = Object.fromEntries(this.phones.map(({ id }, seat) => [seat, id]));
    const told: RoundSeats = { clients, bots: [] };
    const plan: RoundPlan = {
      id: `round ${(this.#rounds += 1)}`,
      game: 'hill',
      seed: 1,
      seats,
      startsAtMs: Date.now(),
    };
    // Nobody is to fall while it is measured
    this.screen.publish(settingTopic('hill', 'speed'), 'double', 0.02);
    this.screen.publish(SEATS_TOPIC, 'string', JSON.stringify(told));
    this.screen.publish(ROUND_TOPIC, 'string', JSON.stringify(plan), { immediate: true });
    let step = 0;
    this.#timer ??= setInterval(() => {
      step += 1;
      for (const [seat, phone] of this.phones.entries()) {
        const value = { x: Math.sin(step / 20 + seat), y: Math.cos(step / 20 + seat) };
        phone.publish(phoneTopic(phone.id, 'stick'), 'vector2', value, { immediate: true });
      }
    }, SEND_MS);
  }

  async stop(): Promise<void> {
    clearInterval(this.#timer);
    await Promise.all(this.#clients.map((client) => client.close()));
    await this.#session.stop();
  }
}
