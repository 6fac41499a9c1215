import { defineProcessingModule, moduleToWire, type AnyModuleDefinition } from '@ubii/pm-sandbox';
import { fromJson, toJson, type ProcessingModule } from '@ubii/proto';
import { GAMES, STEPS_PER_SECOND, type GameId } from '../sim/index.ts';

/** The asset set with the rules of the games, which the modules call. */
export const PARTY_SET = 'party';

/** Whether phones answer questions in a game, such as with what a photo shows. */
export const takesAnswers = (game: GameId): boolean => GAMES[game].controller.steering === 'camera';

export const partyModuleName = (game: GameId): string => `party-${game}`;

/**
 * One module a game: it plays the round of its input `round` with the phones of its input `seats`, on any node. Its code is
 * text, the same in every bundle; the rules are in the asset set.
 */
export function partyModules(): ProcessingModule[] {
  return (Object.keys(GAMES) as GameId[]).map((id) => {
    const wire = moduleToWire(definitionOf(id));
    return fromJson('ubii.processing.ProcessingModule', {
      ...toJson('ubii.processing.ProcessingModule', wire),
      onProcessingStringified: codeOf(id),
    });
  });
}

const codeOf = (id: GameId): string => `(deltaTimeMs, inputs, state) => {
  // The rules: demos/ubi-party/src/sim/${id}
  state.playing ??= {};
  return state.modules.${PARTY_SET}.playRound('${id}', inputs, state.playing, state.masterTimeMs);
}`;

function definitionOf(id: GameId): AnyModuleDefinition {
  const { title, settings } = GAMES[id];
  return defineProcessingModule({
    name: partyModuleName(id),
    description: `Plays ${title} with the phones of a room.`,
    tags: ['party', 'game'],
    authors: ['Ubi-Interact'],
    version: '1.0.0',
    assets: [PARTY_SET],
    inputs: {
      round: 'string',
      seats: 'string',
      sticks: { format: 'vector2', list: true },
      buttons: { format: 'bool', list: true },
      pressed: { format: 'double', list: true },
      ...(takesAnswers(id) && { answers: { format: 'object2D', list: true } as const }),
      ...Object.fromEntries(
        Object.entries(settings).map(([name, value]) => [
          name,
          { format: 'double', default: value } as const,
        ]),
      ),
    },
    outputs: { state: 'string', feedback: { format: 'string', list: true } },
    mode: { frequency: { hertz: STEPS_PER_SECOND } },
    onProcessing: () => undefined,
  });
}
