import { MuxIdentity, type Init, type Session } from '@ubii/proto';
import { GAMES, type GameId } from '../../sim/index.ts';
import {
  PHONE_DEVICE,
  PHONE_COMPONENTS,
  ROUND_TOPIC,
  SEATS_TOPIC,
  settingTopic,
  stateTopic,
} from '../topics.ts';
import { partyModuleName, takesAnswers } from '../../modules/index.ts';

/** Marks the sessions of the party. */
export const PARTY_TAG = 'ubi-party';

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
