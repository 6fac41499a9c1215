import { withoutPayload, withPayload } from './define-service.ts';

/** Services that play recordings into live topics. [RP-1] [RP-5] [RP-6] [RP-7] */
export const REPLAY_SERVICES = {
  replayStart: withPayload(
    '/services/ubii/replay_start',
    'replayStartRequest',
    'replay',
    'Plays a finished recording into live topics, as a client of its own.',
  ),
  replayChange: withPayload(
    '/services/ubii/replay_change',
    'replayChangeRequest',
    'replay',
    'Plays, pauses, steps or seeks a replay, or changes its rate or loop.',
  ),
  replayStop: withPayload(
    '/services/ubii/replay_stop',
    'replayRequest',
    'success',
    'Stops a replay: its clients and topics end, and live topics flow again.',
  ),
  replayList: withoutPayload(
    '/services/ubii/replay_list',
    'replayList',
    'Lists the replays of the master.',
  ),
} as const;
