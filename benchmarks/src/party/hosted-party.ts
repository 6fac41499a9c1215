import { createClient, systemClock, type UbiiClient } from '@ubii/client-web/node';
import type { MasterProcess } from '@ubii/harness';
import { PartyPhone, settingTopic, type RoomView } from '@ubii/party/net';

export const PLAYERS = 32;
/** Phones steer so often. */
const STEER_MS = 1000 / 60;
const LOOK_MS = 100;
const GIVE_UP_MS = 60_000;
/** Nobody is to leave the track, or to arrive, while it is measured. */
const SPEED = 0.02;
/** A round lasts at least four minutes then; a measurement ends before. */
const LONGEST_AGE_MS = 180_000;

/** 32 phones that join the party which a page of a browser leads, and steer at 60 Hz. */
export class HostedParty {
  readonly phones: readonly PartyPhone[];
  readonly #clients: readonly UbiiClient[];
  readonly #timer: NodeJS.Timeout;
  #seat = 0;

  private constructor(clients: readonly UbiiClient[], phones: readonly PartyPhone[]) {
    this.#clients = clients;
    this.phones = phones;
    let step = 0;
    this.#timer = setInterval(() => {
      step += 1;
      for (const [seat, phone] of phones.entries()) phone.steer(Math.sin(step / 20 + seat) / 5, 0);
    }, STEER_MS);
  }

  static async open(master: MasterProcess): Promise<HostedParty> {
    const clients = Array.from({ length: PLAYERS + 1 }, (_, index) =>
      createClient({ url: master.url, name: `phone ${index}`, publishIntervalMs: 0 }),
    );
    await Promise.all(clients.map((client) => client.connect()));
    const phones = clients.slice(0, PLAYERS).map((client) => new PartyPhone(client, systemClock));
    await Promise.all(phones.map((phone) => phone.start()));
    clients[PLAYERS]!.publish(settingTopic('race', 'speed'), 'double', SPEED);
    return new HostedParty(clients, phones);
  }

  /** Leads the room to a race in which all play, with the page that is open. */
  async play(): Promise<void> {
    const [leader] = this.phones;
    const beganMs = performance.now();
    await this.#joinAll();
    for (;;) {
      const { view, nowMs } = leader!.facts;
      const { phase, games } = view!.room;
      const ageMs = nowMs() - (view!.round?.startsAtMs ?? 0);
      const isFull = view!.room.players.every(({ awaySinceMs }) => awaySinceMs === undefined);
      if (phase === 'play' && isFull && ageMs > 1000 && ageMs < LONGEST_AGE_MS) return;
      if (phase === 'lobby') {
        if (games.join() !== 'race') await leader!.ask({ type: 'set-games', games: ['race'] });
        await leader!.ask({ type: 'proceed' });
      } else if (phase === 'explanation' || phase === 'podium' || phase === 'end')
        await leader!.ask({ type: 'proceed' }).catch(() => undefined);
      await new Promise((resolve) => setTimeout(resolve, LOOK_MS));
      if (performance.now() - beganMs > GIVE_UP_MS)
        throw new Error(`The party is in the phase "${phase}" and not in a race after a minute.`);
    }
  }

  /** Each in turn. */
  nextPhone(): { readonly seat: number; readonly phone: PartyPhone } {
    this.#seat = (this.#seat + 1) % PLAYERS;
    const phone = this.phones[this.#seat]!;
    return { seat: phone.facts.me!.seat, phone };
  }

  async stop(): Promise<void> {
    clearInterval(this.#timer);
    for (const phone of this.phones) phone.close();
    await Promise.all(this.#clients.map((client) => client.close()));
  }

  /** The room is known as soon as a page leads it. */
  async #joinAll(): Promise<void> {
    const [leader] = this.phones;
    const players = (): RoomView['room']['players'] => leader!.facts.view?.room.players ?? [];
    for (const [index, phone] of this.phones.entries()) {
      if (phone.facts.me) continue;
      await phone.ask({ type: 'join', name: `P${index}` });
    }
    while (players().length < PLAYERS) await new Promise((resolve) => setTimeout(resolve, LOOK_MS));
  }
}
