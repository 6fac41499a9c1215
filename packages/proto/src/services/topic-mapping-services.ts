import { withoutPayload, withPayload } from './define-service.ts';

/** Services about multiplexers and demultiplexers: stored ones and those in use. */
export const TOPIC_MAPPING_SERVICES = {
  topicDemuxDatabaseSave: withPayload(
    '/services/device/topic_demux/database/save',
    'topicDemux',
    'topicDemux',
    'Stores a demultiplexer.',
    { constant: 'TOPIC_DEMUX_DATABASE_SAVE' },
  ),
  topicDemuxDatabaseDelete: withPayload(
    '/services/device/topic_demux/database/delete',
    'topicDemux',
    'success',
    'Deletes a stored demultiplexer.',
    { constant: 'TOPIC_DEMUX_DATABASE_DELETE' },
  ),
  topicDemuxDatabaseGet: withPayload(
    '/services/device/topic_demux/database/get',
    'topicDemux',
    'topicDemux',
    'Returns the stored demultiplexer with the given id.',
    { constant: 'TOPIC_DEMUX_DATABASE_GET' },
  ),
  topicDemuxDatabaseGetList: withoutPayload(
    '/services/device/topic_demux/database/get_list',
    'topicDemuxList',
    'Lists the stored demultiplexers.',
    { constant: 'TOPIC_DEMUX_DATABASE_GET_LIST' },
  ),
  topicDemuxRuntimeGet: withPayload(
    '/services/device/topic_demux/runtime/get',
    'topicDemux',
    'topicDemux',
    'Returns the demultiplexer in use with the given id.',
    { constant: 'TOPIC_DEMUX_RUNTIME_GET' },
  ),
  topicDemuxRuntimeGetList: withoutPayload(
    '/services/device/topic_demux/runtime/get_list',
    'topicDemuxList',
    'Lists the demultiplexers in use.',
    { constant: 'TOPIC_DEMUX_RUNTIME_GET_LIST' },
  ),
  topicMuxDatabaseSave: withPayload(
    '/services/device/topic_mux/database/save',
    'topicMux',
    'topicMux',
    'Stores a multiplexer.',
    { constant: 'TOPIC_MUX_DATABASE_SAVE' },
  ),
  topicMuxDatabaseDelete: withPayload(
    '/services/device/topic_mux/database/delete',
    'topicMux',
    'success',
    'Deletes a stored multiplexer.',
    { constant: 'TOPIC_MUX_DATABASE_DELETE' },
  ),
  topicMuxDatabaseGet: withPayload(
    '/services/device/topic_mux/database/get',
    'topicMux',
    'topicMux',
    'Returns the stored multiplexer with the given id.',
    { constant: 'TOPIC_MUX_DATABASE_GET' },
  ),
  topicMuxDatabaseGetList: withoutPayload(
    '/services/device/topic_mux/database/get_list',
    'topicMuxList',
    'Lists the stored multiplexers.',
    { constant: 'TOPIC_MUX_DATABASE_GET_LIST' },
  ),
  topicMuxRuntimeGet: withPayload(
    '/services/device/topic_mux/runtime/get',
    'topicMux',
    'topicMux',
    'Returns the multiplexer in use with the given id.',
    { constant: 'TOPIC_MUX_RUNTIME_GET' },
  ),
  topicMuxRuntimeGetList: withoutPayload(
    '/services/device/topic_mux/runtime/get_list',
    'topicMuxList',
    'Lists the multiplexers in use.',
    { constant: 'TOPIC_MUX_RUNTIME_GET_LIST' },
  ),
} as const;
