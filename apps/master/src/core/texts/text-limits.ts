import type { LimitName } from '../limits/index.ts';

/** Treatment of a client's text that is too long. [EX-70] */
export type TextRule =
  | {
      /** Its unit says whether bytes or characters are counted. */
      readonly limit: LimitName;
      /**
       * `refuse` for what something is found by, and for what people keep here; `cut` for what only describes;
       * `line` is cut, too, and stands on one line.
       */
      readonly over: 'refuse' | 'cut' | 'line';
    }
  | {
      /** Why there is no limit of its own. */
      readonly unlimited: string;
    };

const ID = refuse('idCharacters');
const NAME = line('nameCharacters');
const IDENTIFIER = refuse('identifierCharacters');
const TAG = line('tagCharacters');
const KEPT_TAG = refuse('tagCharacters');
const DESCRIPTION = cut('descriptionCharacters');
const KEPT_DESCRIPTION = refuse('descriptionCharacters');
const REASON = line('reasonCharacters');
const TOPIC = refuse('topicBytes');
const PATTERN = refuse('patternLength');
const SECRET = cut('secretCharacters');
const JSON_TEXT = refuse('jsonCharacters');
const WORD = line('libraryCharacters');
const SOURCE = unlimited(
  'Counted with the module, in `moduleSourceBytes`, `sessionBytes` and registrations.',
);
const RECORD = unlimited('Data, not a text for people: counted with its message, in `frameBytes`.');
const NOT_KEPT = unlimited(
  'Compared with what is known, and not kept; errors quote its beginning.',
);
const OF_MASTER = unlimited('Set by the master; what a client sends there is not read.');

/** Texts in one list, of a field that holds several [EX-71]. */
export const LISTED_TEXTS: Readonly<Record<string, 'refuse' | 'cut'>> = {
  'ubii.clients.Client.tags': 'cut',
  'ubii.devices.Device.tags': 'cut',
  'ubii.devices.Component.tags': 'cut',
  'ubii.devices.Component.notify_condition_ids': 'cut',
  'ubii.extension.NodeExtension.libraries': 'cut',
  'ubii.extension.ModuleExtension.libraries': 'refuse',
  'ubii.extension.ModuleExtension.assets': 'refuse',
  'ubii.extension.ModuleExtension.optional_assets': 'refuse',
  'ubii.extension.FlightRecordsRequest.topics': 'refuse',
  'ubii.extension.RecordingSelection.topics': 'refuse',
  'ubii.extension.RecordingSelection.patterns': 'refuse',
  'ubii.extension.RecordingSelection.clients': 'refuse',
  'ubii.extension.RecordingSelection.devices': 'refuse',
  'ubii.extension.RecordingSelection.sessions': 'refuse',
  'ubii.extension.RecordingSelection.excluded_patterns': 'refuse',
  'ubii.extension.Study.setting_patterns': 'refuse',
  'ubii.extension.ReplayStartRequest.topics': 'refuse',
  'ubii.extension.ReplayStartRequest.excluded_topics': 'refuse',
  'ubii.processing.ModuleIO.choices': 'refuse',
  'ubii.processing.ProcessingModule.authors': 'refuse',
  'ubii.processing.ProcessingModule.tags': 'refuse',
  'ubii.sessions.Session.authors': 'refuse',
  'ubii.sessions.Session.tags': 'refuse',
};

/** Every text that a client can give in a request or tell as a node, by the full name of its field [EX-70]; a message stands for all its fields. */
export const TEXT_RULES: Readonly<Record<string, TextRule>> = {
  'ubii.services.ServiceRequest.topic': NOT_KEPT,

  'ubii.clients.Client.id': ID,
  'ubii.clients.Client.name': NAME,
  'ubii.clients.Client.tags': TAG,
  'ubii.clients.Client.description': DESCRIPTION,
  'ubii.clients.Client.host_ip': WORD,
  'ubii.clients.Client.metadata_json': JSON_TEXT,
  'ubii.extension.ClientExtension.resume_token': SECRET,
  'ubii.extension.ClientExtension.master_version': OF_MASTER,
  'ubii.extension.ClientExtension.library': WORD,
  'ubii.extension.ClientExtension.credential': OF_MASTER,
  'ubii.extension.ClientExtension.masters': OF_MASTER,
  'ubii.extension.ClientExtension.master_id': OF_MASTER,
  'ubii.extension.NodeExtension.libraries': WORD,

  'ubii.devices.Device.id': ID,
  'ubii.devices.Device.name': NAME,
  'ubii.devices.Device.client_id': ID,
  'ubii.devices.Device.tags': TAG,
  'ubii.devices.Device.description': DESCRIPTION,
  'ubii.devices.Component.topic': TOPIC,
  'ubii.devices.Component.message_format': IDENTIFIER,
  'ubii.devices.Component.device_id': ID,
  'ubii.devices.Component.tags': TAG,
  'ubii.devices.Component.description': DESCRIPTION,
  'ubii.devices.Component.id': ID,
  'ubii.devices.Component.name': IDENTIFIER,
  'ubii.devices.Component.notify_condition_ids': ID,

  'ubii.devices.TopicMux.id': ID,
  'ubii.devices.TopicMux.name': IDENTIFIER,
  'ubii.devices.TopicMux.data_type': IDENTIFIER,
  'ubii.devices.TopicMux.topic_selector': PATTERN,
  'ubii.devices.TopicMux.identity_match_pattern': PATTERN,
  'ubii.devices.TopicMux.topic_glob': PATTERN,
  'ubii.devices.TopicDemux.id': ID,
  'ubii.devices.TopicDemux.name': IDENTIFIER,
  'ubii.devices.TopicDemux.data_type': IDENTIFIER,
  'ubii.devices.TopicDemux.output_topic_format': TOPIC,

  'ubii.services.request.TopicSubscription.client_id': ID,
  'ubii.services.request.TopicSubscription.subscribe_topics': TOPIC,
  'ubii.services.request.TopicSubscription.unsubscribe_topics': TOPIC,
  'ubii.services.request.TopicSubscription.subscribe_topic_regexp': PATTERN,
  'ubii.services.request.TopicSubscription.unsubscribe_topic_regexp': PATTERN,

  'ubii.sessions.Session.id': ID,
  'ubii.sessions.Session.name': IDENTIFIER,
  'ubii.sessions.Session.tags': KEPT_TAG,
  'ubii.sessions.Session.description': KEPT_DESCRIPTION,
  'ubii.sessions.Session.authors': refuse('nameCharacters'),
  'ubii.sessions.IOMapping.processing_module_id': ID,
  'ubii.sessions.IOMapping.processing_module_name': IDENTIFIER,
  'ubii.sessions.TopicInputMapping.input_name': IDENTIFIER,
  'ubii.sessions.TopicInputMapping.topic': TOPIC,
  'ubii.sessions.TopicInputMapping.constant_json': JSON_TEXT,
  'ubii.sessions.TopicOutputMapping.output_name': IDENTIFIER,
  'ubii.sessions.TopicOutputMapping.topic': TOPIC,
  'ubii.extension.SessionExtension.editor_json': unlimited(
    'Counted with the session, in `sessionBytes`; only graph editors read it.',
  ),
  'ubii.extension.SessionExtension.grant_ids': OF_MASTER,
  'ubii.extension.SessionExtension.master_id': OF_MASTER,
  'ubii.extension.SessionExtension.moved_from': OF_MASTER,
  'ubii.extension.SessionProblem.code': OF_MASTER,
  'ubii.extension.SessionProblem.message': OF_MASTER,
  'ubii.extension.SessionProblem.path': OF_MASTER,
  'ubii.extension.SessionProblem.module_id': OF_MASTER,
  'ubii.extension.SessionProblem.module_name': OF_MASTER,
  'ubii.extension.SessionProblem.node_id': OF_MASTER,

  'ubii.processing.ProcessingModule.id': ID,
  'ubii.processing.ProcessingModule.name': IDENTIFIER,
  'ubii.processing.ProcessingModule.authors': refuse('nameCharacters'),
  'ubii.processing.ProcessingModule.tags': KEPT_TAG,
  'ubii.processing.ProcessingModule.description': KEPT_DESCRIPTION,
  'ubii.processing.ProcessingModule.node_id': ID,
  'ubii.processing.ProcessingModule.session_id': ID,
  'ubii.processing.ProcessingModule.on_processing_stringified': SOURCE,
  'ubii.processing.ProcessingModule.on_created_stringified': SOURCE,
  'ubii.processing.ProcessingModule.on_halted_stringified': SOURCE,
  'ubii.processing.ProcessingModule.on_destroyed_stringified': SOURCE,
  'ubii.processing.ProcessingMode.Lockstep.process_request_endpoint': IDENTIFIER,
  'ubii.processing.ModuleIO.internal_name': IDENTIFIER,
  'ubii.processing.ModuleIO.message_format': IDENTIFIER,
  'ubii.processing.ModuleIO.default_json': JSON_TEXT,
  'ubii.processing.ModuleIO.description': refuse('ioDescriptionCharacters'),
  'ubii.processing.ModuleIO.choices': refuse('choiceCharacters'),
  'ubii.extension.ModuleExtension.version': WORD,
  'ubii.extension.ModuleExtension.libraries': IDENTIFIER,
  'ubii.extension.ModuleExtension.assets': IDENTIFIER,
  'ubii.extension.ModuleExtension.optional_assets': IDENTIFIER,
  'ubii.extension.AssetSetRequest.name': NOT_KEPT,
  'ubii.extension.ModuleExtension.grant_ids': OF_MASTER,
  'ubii.extension.TopicSubscribersRequest.topics': TOPIC,
  'ubii.extension.ModuleVersionRequest.name': IDENTIFIER,
  'ubii.extension.ModuleVersionRequest.module_id': ID,

  'ubii.processing.LockstepProcessingRequest.processing_module_ids': ID,
  'ubii.processing.LockstepProcessingRequest.session_id': ID,
  'ubii.topicData.TopicDataRecord': RECORD,

  'ubii.conditions.NotifyCondition.id': ID,
  'ubii.conditions.NotifyCondition.name': IDENTIFIER,
  'ubii.conditions.NotifyCondition.evaluation_function_stringified': refuse('moduleSourceBytes'),

  'ubii.extension.ClientReportRequest.client_ids': ID,
  'ubii.extension.ClientRenameRequest.client_id': ID,
  'ubii.extension.ClientRenameRequest.target_id': ID,
  'ubii.extension.ClientRenameRequest.name': refuse('nameCharacters'),
  'ubii.extension.ClientDisconnectRequest.client_id': ID,
  'ubii.extension.ClientDisconnectRequest.target_id': ID,
  'ubii.extension.ClientDisconnectRequest.reason': REASON,
  'ubii.extension.ClientThrottleRequest.client_id': ID,
  'ubii.extension.ClientThrottleRequest.target_id': ID,
  'ubii.extension.ClientThrottleRequest.reason': REASON,

  'ubii.extension.MasterProofRequest.target_id': ID,
  'ubii.extension.MasterProofRequest.host': NOT_KEPT,
  'ubii.extension.MasterProofRequest.nonce': unlimited(
    'Refused unless it has 16 to 64 characters.',
  ),
  'ubii.extension.JoinCheckRequest.token': SECRET,
  'ubii.extension.AccessGrantCreateRequest.client_id': ID,
  'ubii.extension.AccessGrantCreateRequest.label': refuse('nameCharacters'),
  'ubii.extension.AccessGrantCreateRequest.target': refuse('pathCharacters'),
  'ubii.extension.AccessGrantCreateRequest.read_topics': TOPIC,
  'ubii.extension.AccessGrantCreateRequest.write_topics': TOPIC,
  'ubii.extension.AuditLogRequest.client_id': ID,
  'ubii.extension.AuditLogRequest.grant_id': ID,
  'ubii.extension.AuditLogRequest.service': IDENTIFIER,
  'ubii.extension.AuditLogRequest.text': REASON,
  'ubii.extension.AccessGrantRevokeRequest.client_id': ID,
  'ubii.extension.AccessGrantRevokeRequest.grant_id': ID,
  'ubii.extension.AccessGrantRevokeRequest.reason': REASON,

  'ubii.extension.BridgeMappingsRequest.target_id': NOT_KEPT,
  'ubii.extension.BridgeMappingsChange.target_id': NOT_KEPT,
  'ubii.extension.BridgeMappingsChange.mappings_json': JSON_TEXT,
  'ubii.extension.BridgeMappingsChange.revision': NOT_KEPT,
  'ubii.extension.BridgeMappingsChange.client_id': NOT_KEPT,
  'ubii.extension.BridgeMappings.protocol': WORD,
  'ubii.extension.BridgeMappings.mappings_json': JSON_TEXT,
  'ubii.extension.BridgeMappings.revision': WORD,
  'ubii.extension.BridgeMappings.file': DESCRIPTION,
  'ubii.extension.BridgeMappings.file_problem': DESCRIPTION,
  'ubii.extension.BridgeMappingProblem.member': WORD,
  'ubii.extension.BridgeMappingProblem.message': DESCRIPTION,
  'ubii.extension.BridgeMatch.source': DESCRIPTION,
  'ubii.extension.BridgeMatch.target': DESCRIPTION,
  'ubii.extension.BridgeOrder.author': OF_MASTER,
  'ubii.extension.NodeRecorderStart.maker_id': OF_MASTER,
  'ubii.extension.NodeRecorderStart.master_name': OF_MASTER,
  'ubii.extension.NodeRecorderStart.version': OF_MASTER,
  'ubii.extension.NodeRecorderStart.personal_data': OF_MASTER,
  'ubii.extension.NodeRecorderSources.recording_id': OF_MASTER,
  'ubii.extension.NodeRecorderSource.topic': OF_MASTER,
  'ubii.extension.NodeRecorderSource.client_id': OF_MASTER,
  'ubii.extension.NodeRecorderClock.client_id': OF_MASTER,
  'ubii.extension.Recording.id': ID,
  'ubii.extension.Recording.name': NAME,
  'ubii.extension.Recording.problem': line('eventCharacters'),
  'ubii.extension.Recording.notes': DESCRIPTION,
  'ubii.extension.Recording.author': NAME,
  'ubii.extension.Recording.replayed_recording_id': ID,
  'ubii.extension.Recording.node_id': OF_MASTER,
  'ubii.extension.Recording.node_name': OF_MASTER,
  'ubii.extension.RecordingTopic.topic': TOPIC,
  'ubii.extension.RecordingTopic.client_id': ID,
  'ubii.extension.RecordingTopic.client_name': NAME,
  'ubii.extension.RecordingTopic.data_format': IDENTIFIER,
  'ubii.extension.RecordingStudy.study_id': ID,
  'ubii.extension.RecordingStudy.study_name': NAME,
  'ubii.extension.RecordingStudy.run_id': ID,
  'ubii.extension.RecordingStudy.participant_code': NAME,
  'ubii.extension.RecordingStudy.visit': NAME,
  'ubii.extension.RecordingStudy.condition': NAME,
  'ubii.general.Error.title': NAME,
  'ubii.general.Error.message': DESCRIPTION,
  'ubii.general.Error.stack': unlimited('What a node sends there is not read.'),
  'ubii.general.Error.code': IDENTIFIER,
  'ubii.extension.RecordingRequest.id': ID,
  'ubii.extension.RecordingStartRequest.node_id': ID,
  'ubii.extension.RecordingStartRequest.client_id': ID,
  'ubii.extension.RecordingStartRequest.name': refuse('nameCharacters'),
  'ubii.extension.RecordingStartRequest.notes': KEPT_DESCRIPTION,
  'ubii.extension.RecordingSelection.topics': TOPIC,
  'ubii.extension.RecordingSelection.patterns': PATTERN,
  'ubii.extension.RecordingSelection.clients': ID,
  'ubii.extension.RecordingSelection.devices': refuse('nameCharacters'),
  'ubii.extension.RecordingSelection.sessions': ID,
  'ubii.extension.RecordingSelection.excluded_patterns': PATTERN,
  'ubii.extension.RecordingChangeRequest.id': ID,
  'ubii.extension.RecordingChangeRequest.name': refuse('nameCharacters'),
  'ubii.extension.RecordingChangeRequest.notes': KEPT_DESCRIPTION,
  'ubii.extension.RecordingMarker.recording_id': ID,
  'ubii.extension.RecordingMarker.id': ID,
  'ubii.extension.RecordingMarker.text': line('eventCharacters'),
  'ubii.extension.RecordingMarker.author': NAME,
  'ubii.extension.RecordingMarker.client_id': ID,
  'ubii.extension.PersonalLabel.id': ID,
  'ubii.extension.PersonalLabel.topic_pattern': PATTERN,
  'ubii.extension.PersonalLabel.field_path': refuse('identifierCharacters'),
  'ubii.extension.PersonalLabel.note': KEPT_DESCRIPTION,
  'ubii.extension.FlightRecorderKeepRequest.client_id': ID,
  'ubii.extension.FlightRecorderKeepRequest.name': refuse('nameCharacters'),
  'ubii.extension.FlightRecorderKeepRequest.notes': KEPT_DESCRIPTION,
  'ubii.extension.FlightRecordsRequest.client_id': ID,
  'ubii.extension.FlightRecordsRequest.topics': TOPIC,
  'ubii.extension.Study.id': ID,
  'ubii.extension.Study.name': refuse('nameCharacters'),
  'ubii.extension.Study.notes': KEPT_DESCRIPTION,
  'ubii.extension.Study.consent_text': refuse('consentCharacters'),
  'ubii.extension.Study.name_template': refuse('nameTemplateCharacters'),
  'ubii.extension.Study.setting_patterns': PATTERN,
  'ubii.extension.StudyConsentText.text': OF_MASTER,
  'ubii.extension.StudyCondition.name': refuse('nameCharacters'),
  'ubii.extension.StudyCondition.session_id': ID,
  'ubii.extension.StudyDevice.name': refuse('nameCharacters'),
  'ubii.extension.StudyDevice.topic_pattern': PATTERN,
  'ubii.extension.StudyDevice.data_format': refuse('identifierCharacters'),
  'ubii.extension.StudyDevice.tag': KEPT_TAG,
  'ubii.extension.StudyRequest.id': ID,
  'ubii.extension.StudyRunStartRequest.client_id': ID,
  'ubii.extension.StudyRunStartRequest.study_id': ID,
  'ubii.extension.StudyRunStartRequest.participant_code': ID,
  'ubii.extension.StudyRunStartRequest.visit': ID,
  'ubii.extension.StudyRunChangeRequest.client_id': ID,
  'ubii.extension.StudyRunChangeRequest.run_id': ID,
  'ubii.extension.StudyRunChangeRequest.text': KEPT_DESCRIPTION,
  'ubii.extension.StudyRunRequest.id': ID,
  'ubii.extension.StudyRunListRequest.study_id': ID,
  'ubii.extension.StudyRunListRequest.participant_code': NOT_KEPT,
  'ubii.extension.StudyParticipantRequest.study_id': ID,
  'ubii.extension.StudyParticipantRequest.participant_code': NOT_KEPT,

  'ubii.extension.ReplayStartRequest.client_id': ID,
  'ubii.extension.ReplayStartRequest.recording_id': ID,
  'ubii.extension.ReplayStartRequest.topics': PATTERN,
  'ubii.extension.ReplayStartRequest.excluded_topics': PATTERN,
  'ubii.extension.ReplayStartRequest.live_prefix': TOPIC,
  'ubii.extension.ReplayStartRequest.name': refuse('nameCharacters'),
  'ubii.extension.ReplayStartRequest.session_id': ID,
  'ubii.extension.ReplayRename.from_prefix': TOPIC,
  'ubii.extension.ReplayRename.to_prefix': TOPIC,
  'ubii.extension.ReplayChangeRequest.id': ID,
  'ubii.extension.ReplayRequest.id': ID,

  'ubii.processing.LockstepProcessingReply.processing_module_ids': NOT_KEPT,
  'ubii.processing.LockstepProcessingReply.session_id': NOT_KEPT,
  'ubii.extension.EndedTopics.topics': NOT_KEPT,
  'ubii.extension.ModuleStatistics.module_id': NOT_KEPT,
  'ubii.extension.ModuleStatistics.module_name': OF_MASTER,
  'ubii.extension.ModuleStatistics.node_id': OF_MASTER,
  'ubii.extension.ModuleStatistics.refused_output': line('identifierCharacters'),
  'ubii.extension.ModuleStatistics.loading_set': line('identifierCharacters'),
  'ubii.extension.ModuleEvent.session_id': OF_MASTER,
  'ubii.extension.ModuleEvent.module_id': NOT_KEPT,
  'ubii.extension.ModuleEvent.module_name': OF_MASTER,
  'ubii.extension.ModuleEvent.node_id': OF_MASTER,
  'ubii.extension.ModuleEvent.phase': WORD,
  'ubii.extension.ModuleEvent.message': DESCRIPTION,
  'ubii.extension.ModuleEvent.level': WORD,
};

function refuse(limit: LimitName): TextRule {
  return { limit, over: 'refuse' };
}

function cut(limit: LimitName): TextRule {
  return { limit, over: 'cut' };
}

function line(limit: LimitName): TextRule {
  return { limit, over: 'line' };
}

function unlimited(reason: string): TextRule {
  return { unlimited: reason };
}
