import { withoutPayload, withPayload } from './define-service.ts';

/** Services on recordings of topics and on the flight recorder. [RC-3] to [RC-6], [RC-15], [RC-20], [RC-30] to [RC-32], [RC-36], [RC-63], [PD-3], [PD-4] */
export const RECORDING_SERVICES = {
  recordingList: withoutPayload(
    '/services/ubii/recording_list',
    'recordingList',
    'Lists the recordings of the master, with the space they take.',
  ),
  recordingGet: withPayload(
    '/services/ubii/recording_get',
    'recordingRequest',
    'recording',
    'Returns a recording with its topics and markers.',
  ),
  recordingStart: withPayload(
    '/services/ubii/recording_start',
    'recordingStartRequest',
    'recording',
    'Starts a recording of topics, clients, devices or sessions.',
  ),
  recordingStop: withPayload(
    '/services/ubii/recording_stop',
    'recordingRequest',
    'recording',
    'Stops a running recording and closes its file.',
  ),
  recordingChange: withPayload(
    '/services/ubii/recording_change',
    'recordingChangeRequest',
    'recording',
    'Changes name and notes of a recording.',
  ),
  recordingDelete: withPayload(
    '/services/ubii/recording_delete',
    'recordingRequest',
    'success',
    'Deletes a recording and its file.',
  ),
  recordingUpload: withPayload(
    '/services/ubii/recording_upload',
    'recordingRequest',
    'recording',
    'Asks the node that has a recording to upload it.',
  ),
  recordingMark: withPayload(
    '/services/ubii/recording_mark',
    'recordingMarker',
    'recordingMarker',
    'Adds, changes or removes a marker of one recording, or of all running ones and the flight recorder.',
  ),
  recordingEstimate: withPayload(
    '/services/ubii/recording_estimate',
    'recordingSelection',
    'recordingEstimate',
    'Measures for one second how many records and bytes a selection has.',
  ),
  flightRecorderGet: withoutPayload(
    '/services/ubii/flight_recorder_get',
    'flightRecorder',
    'Describes the flight recorder: what it keeps and what it holds.',
  ),
  flightRecorderSet: withPayload(
    '/services/ubii/flight_recorder_set',
    'flightRecorderSettings',
    'flightRecorder',
    'Turns the flight recorder on or off, and changes what it keeps.',
  ),
  flightRecorderKeep: withPayload(
    '/services/ubii/flight_recorder_keep',
    'flightRecorderKeepRequest',
    'recording',
    'Keeps what the flight recorder holds as a recording.',
  ),
  flightRecorderRecords: withPayload(
    '/services/ubii/flight_recorder_records',
    'flightRecordsRequest',
    'flightRecords',
    'Reads what the flight recorder holds of some topics.',
  ),
  personalDataGet: withoutPayload(
    '/services/ubii/personal_data_get',
    'personalData',
    'Lists the labels of personal data in topics.',
  ),
  personalDataSet: withPayload(
    '/services/ubii/personal_data_set',
    'personalData',
    'personalData',
    'Replaces the labels of personal data in topics.',
  ),
} as const;

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
