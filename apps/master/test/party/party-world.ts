import { build } from 'esbuild';
import { fileURLToPath } from 'node:url';
import { createAssetStore } from '@ubii/pm-sandbox';
import { FakeAssets } from '@ubii/pm-sandbox/testing';
import { createMemoryServices, createMemoryTopicData } from '@ubii/client-web/testing';
import { createMemoryIdentity } from '@ubii/client-web/node';
import type {
  ClientOptions,
  ClientProblem,
  Clock,
  IdentityStorage,
  UbiiClient,
} from '@ubii/client-web/node';
import { PARTY_SET, partyModules, type RoundState } from '@ubii/party/modules';
import { PartyHost, PartyPhone, type HostMemory, type RoomView } from '@ubii/party/net';
import {
  GAMES,
  type Cheer,
  type Controls,
  type Game,
  type GameId,
  type Seat,
} from '@ubii/party/sim';
import { settle } from '@ubii/timing/testing';
import { vi } from 'vitest';
import { ClientWorld } from '../client-world.ts';
import { behindLine, type Line } from './slow-line.ts';

const STEP_MS = 1000 / 60;

/** The script that modules of the games call, as the build makes it. */
export async function buildPartyLibrary(): Promise<FakeAssets> {
  const entry = fileURLToPath(
    new URL('../../../../demos/ubi-party/src/modules/library.ts', import.meta.url),
  );
  const { outputFiles } = await build({
    entryPoints: [entry],
    bundle: true,
    write: false,
    platform: 'neutral',
    format: 'iife',
    globalName: 'ubiiParty',
    footer: { js: 'ubiiParty;' },
  });
  const assets = new FakeAssets();
  assets.add(PARTY_SET, { 'party.js': outputFiles[0]!.text }, 'party.js');
  return assets;
}

/** Options of a phone. */
export interface PhoneOptions {
  /** Of an invitation; default: a phone that is trusted as it is. */
  readonly joinToken?: string;
  /** Network address; by default, all phones have the same one. */
  readonly address?: string;
  readonly clock?: Clock;
  readonly line?: Line;
}

/** A phone whose player plays as a bot would, from what the big screen shows. */
export interface ScriptedPhone {
  readonly name: string;
  readonly identity: IdentityStorage;
  readonly options: PhoneOptions;
  /** Refusals by the master. */
  problems: readonly ClientProblem[];
  client: UbiiClient;
  phone: PartyPhone;
  /** Neither looks nor presses. */
  isAsleep: boolean;
}

/** A party in memory: a master that plays the games, a big screen without a screen, and phones. */
export class PartyWorld {
  readonly world: ClientWorld;
  readonly phones: ScriptedPhone[] = [];
  readonly troubles: string[] = [];
  /** Clients of screens that were superseded. */
  readonly superseded: string[] = [];
  memory: HostMemory | undefined;
  host!: PartyHost;
  view!: RoomView;
  /** The cheers shown on the big screen, in their order. */
  readonly cheers: Cheer[] = [];
  /** Clients whose photos were on the big screen, one list a change. */
  readonly shownPhotos: (readonly string[])[] = [];
  states: { readonly game: GameId; readonly state: RoundState }[] = [];
  readonly #screenIdentity = createMemoryIdentity();
  #bytes = 0;
  #screen: UbiiClient | undefined;

  constructor(library: FakeAssets) {
    this.world = new ClientWorld(
      {},
      { library: partyModules(), assets: createAssetStore(library) },
    );
  }

  get room(): RoomView['room'] {
    return this.view.room;
  }

  async openScreen({
    identity = this.#screenIdentity,
    clock = this.world.clock,
    line,
  }: { identity?: IdentityStorage; clock?: Clock; line?: Line } = {}): Promise<void> {
    const { client } = await this.world.connect('screen', {
      identity,
      clock,
      ...(line && { transports: this.#transportsOver(line) }),
    });
    this.#screen = client;
    this.host = new PartyHost({
      client,
      clock,
      storage: {
        load: () => this.memory,
        save: (memory) => (this.memory = structuredClone(memory)),
      },
      drawByte: () => (this.#bytes = (this.#bytes * 73 + 41) % 256),
      listener: {
        handleView: (view) => (this.view = view),
        handleState: (game, state) => this.#handleState(game, state),
        handlePhotos: (photos) => this.shownPhotos.push([...photos.keys()]),
        handleCheer: (cheer) => this.cheers.push(cheer),
        handleSuperseded: (id) => this.superseded.push(id),
        handleTrouble: (sentence) => this.troubles.push(sentence),
      },
    });
    let isStarted = false;
    const started = this.host.start().then(() => (isStarted = true));
    await this.until(() => isStarted);
    await started;
    await this.pass(100);
  }

  /** The page is closed, as a reload begins. */
  closeScreen(): void {
    this.host.close();
    this.#screen?.leave();
  }

  addPhone(name: string, options: PhoneOptions = {}): Promise<ScriptedPhone> {
    return this.#addPhone('join', name, options);
  }

  /** A phone that watches without a seat. */
  addSpectator(name: string, options: PhoneOptions = {}): Promise<ScriptedPhone> {
    return this.#addPhone('watch', name, options);
  }

  async #addPhone(
    type: 'join' | 'watch',
    name: string,
    options: PhoneOptions,
  ): Promise<ScriptedPhone> {
    const identity = createMemoryIdentity();
    const scripted = { name, identity, options, isAsleep: false } as ScriptedPhone;
    await this.connectPhone(scripted);
    await this.ask(scripted, { type, name });
    this.phones.push(scripted);
    return scripted;
  }

  /** Opens the page of a phone, or opens it again. */
  async connectPhone(scripted: ScriptedPhone): Promise<void> {
    const { name, identity, options } = scripted;
    const { joinToken, address, clock = this.world.clock, line } = options;
    const { place } = this.world;
    this.world.place = address ?? place;
    // Clients with an invitation connect from another machine
    this.world.standing = joinToken === undefined ? 'trusted' : 'other';
    const { client, problems } = await this.world.connect(name, {
      identity,
      clock,
      ...(joinToken !== undefined && { joinToken }),
      ...(line && { transports: this.#transportsOver(line) }),
    });
    this.world.standing = 'trusted';
    this.world.place = place;
    scripted.problems = problems;
    scripted.client = client;
    scripted.phone = new PartyPhone(client, clock);
    const started = scripted.phone.start();
    await this.pass(100);
    await started;
  }

  #transportsOver(line: Line): ClientOptions['transports'] {
    const master = behindLine(this.world, this.world.clock, line);
    return {
      services: createMemoryServices(master),
      topicData: createMemoryTopicData(master),
    };
  }

  async ask(
    { phone }: ScriptedPhone,
    wish: Parameters<PartyPhone['ask']>[0],
  ): Promise<{ code?: string }> {
    const answer = phone.ask(wish);
    answer.catch(() => undefined);
    await this.pass(100);
    return answer;
  }

  seatOf({ client }: ScriptedPhone): Seat | undefined {
    return this.room.players.find(({ key }) => key === client.id)?.seat;
  }

  /** Lets time pass in steps of the games. */
  async pass(durationMs: number): Promise<void> {
    await settle();
    for (let passed = 0; passed < durationMs; passed += STEP_MS) {
      this.world.clock.advanceSync(STEP_MS);
      await settle();
    }
  }

  /** Lets time pass until something holds. @throws Error after ten minutes */
  async until(holds: () => boolean): Promise<void> {
    for (let passed = 0; !holds(); passed += 50) {
      if (passed > 600_000)
        throw new Error(`not within ten minutes: ${String(holds)}, ${JSON.stringify(this.view)}`);
      await this.pass(50);
    }
  }

  /** All who are there are ready, again and again, until a phase is reached. */
  async playTo(phase: RoomView['room']['phase']): Promise<void> {
    while (this.room.phase !== phase) {
      const before = this.room.phase;
      if (before === 'lobby') this.host.apply({ type: 'proceed', by: 'host' });
      for (const phone of this.phones) {
        if (!phone.isAsleep) void phone.phone.ask({ type: 'ready', isReady: true }).catch(() => {});
      }
      await this.until(() => this.room.phase !== before);
    }
  }

  #handleState(game: GameId, state: RoundState): void {
    this.states.push({ game, state });
    if (game === 'hunt') return; // what phones find, the story says
    for (const scripted of this.phones) {
      const seat = this.seatOf(scripted);
      if (seat === undefined || scripted.isAsleep || state.step % 4 !== 0) continue;
      const controls = botOf(game)(state.state, seat);
      scripted.phone.steer(controls.x, controls.y);
      scripted.phone.press(controls.isPressed);
    }
  }

  async close(): Promise<void> {
    this.host.close();
    for (const { phone } of this.phones) phone.close();
    await this.world.test.master.close();
    vi.restoreAllMocks();
  }
}

const botOf = (id: GameId): ((state: unknown, seat: Seat) => Controls) => {
  const game = GAMES[id] as unknown as Game<unknown>;
  return (state, seat) => game.bot(state, seat);
};
