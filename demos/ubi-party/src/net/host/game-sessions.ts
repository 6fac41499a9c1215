import { MuxIdentity, SessionState, type Init, type Session } from '@ubii/proto';
import { ConnectionError, type UbiiClient } from '@ubii/client-web';

import { partyModuleName, takesAnswers } from '../../modules/index.ts';
import { GAMES, type GameId } from '../../sim/index.ts';
import {
  PHONE_DEVICE,
  PHONE_COMPONENTS,
  ROUND_TOPIC,
  SEATS_TOPIC,
  settingTopic,
  stateTopic,
} from '../protocol.ts';

/** Marks the sessions of the party. */
const PARTY_TAG = 'ubi-party';

/** The session that a game is played in: all phones by muxers, a demuxer to each, settings as topics. */
export function gameSession(id: GameId): Init<Session> {
  const name = partyModuleName(id);
  const { title, settings, explanation } = GAMES[id];
  return {
    name: `Ubi-Party: ${title}`,
    description: explanation[0],
    tags: [PARTY_TAG, id],
    processingModules: [{ name }],
    ioMappings: [
      {
        processingModuleName: name,
        inputMappings: [
          { inputName: 'round', topic: ROUND_TOPIC },
          { inputName: 'seats', topic: SEATS_TOPIC },
          muxer('sticks', 'stick'),
          muxer('buttons', 'button'),
          muxer('pressed', 'pressed'),
          ...(takesAnswers(id) ? [muxer('answers', 'answer')] : []),
          ...Object.keys(settings).map((setting) => ({
            inputName: setting,
            topic: settingTopic(id, setting),
          })),
        ],
        outputMappings: [
          { outputName: 'state', topic: stateTopic(id) },
          {
            outputName: 'feedback',
            topicDemux: {
              name: 'feedback of each player',
              dataType: 'string',
              outputTopicFormat: `/{{#0}}/${PHONE_DEVICE}/feedback`,
            },
          },
        ],
      },
    ],
  };
}

/** The topics of one component of all phones, with the client that publishes as identity. */
function muxer(inputName: string, component: 'stick' | 'button' | 'pressed' | 'answer'): object {
  return {
    inputName,
    topicMux: {
      name: `${component} of each player`,
      dataType: PHONE_COMPONENTS[component].format,
      topicGlob: `/*/${PHONE_DEVICE}/${component}`,
      identitySource: MuxIdentity.MUX_IDENTITY_CLIENT_ID,
    },
  };
}

/** The sessions of the games on the master: one at a time, so that no unused session runs. */
export class GameSessions {
  readonly #client: UbiiClient;
  readonly #handleTrouble: (sentence: string) => void;
  #open: { readonly game: GameId; readonly id: string } | undefined;
  /** One change after the other. */
  #turn: Promise<unknown> = Promise.resolve();

  constructor(client: UbiiClient, handleTrouble: (sentence: string) => void) {
    this.#client = client;
    this.#handleTrouble = handleTrouble;
  }

  idOf(game: GameId): string | undefined {
    return this.#open?.game === game ? this.#open.id : undefined;
  }

  /** Makes sure that the session of a game runs, and no other of the party. @returns whether it was started now */
  open(game: GameId): Promise<boolean> {
    return this.#inTurn(async () => {
      const all = await this.#list();
      const own = all.find((session) => session.tags.includes(game));
      for (const session of all) if (session !== own) await this.#remove(session.id);
      const runs = own !== undefined && isRunning(own);
      const session = runs
        ? own
        : await this.#client.call('sessionRuntimeStart', own ? { id: own.id } : gameSession(game));
      this.#open = { game, id: session.id };
      return !runs;
    }, false);
  }

  removeAll(): Promise<void> {
    return this.#inTurn(async () => {
      this.#open = undefined;
      for (const { id } of await this.#list()) await this.#remove(id);
    }, undefined);
  }

  #inTurn<T>(act: () => Promise<T>, otherwise: T): Promise<T> {
    const done = this.#turn.then(act).catch((cause: unknown) => {
      // The connection says by itself that it is lost
      if (!(cause instanceof ConnectionError))
        this.#handleTrouble(cause instanceof Error ? cause.message : String(cause));
      return otherwise;
    });
    this.#turn = done;
    return done;
  }

  async #list(): Promise<readonly Session[]> {
    const { elements } = await this.#client.call('sessionRuntimeGetList');
    return elements.filter(({ tags }) => tags.includes(PARTY_TAG));
  }

  async #remove(id: string): Promise<void> {
    await this.#client.call('sessionRuntimeRemove', { id });
  }
}

const RUNS: readonly SessionState[] = [
  SessionState.SESSION_STARTING,
  SessionState.SESSION_RUNNING,
  SessionState.SESSION_DEGRADED,
];

function isRunning({ extension }: Session): boolean {
  return RUNS.includes(extension?.state ?? SessionState.SESSION_CREATED);
}
