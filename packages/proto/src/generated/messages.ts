// Made from schema/*.proto by scripts/generate.ts. Change the schema, then run `pnpm generate`.

/**
 * How alive the client is, judged by the master.
 *
 * `ubii.clients.Client.State`
 */
export const ClientState = {
  /** Was active lately. */
  ACTIVE: 0,
  /** Silent for some seconds; everything of it still stands. */
  INACTIVE: 1,
  /** Silent for longer: the values of its topics are gone, its subscriptions stand. */
  UNAVAILABLE: 2,
} as const;
export type ClientState = (typeof ClientState)[keyof typeof ClientState];

/**
 * What happened to a key or button.
 *
 * `ubii.dataStructure.ButtonEventType`
 */
export const ButtonEventType = {
  /** It was released. */
  UP: 0,
  /** It was pressed. */
  DOWN: 1,
} as const;
export type ButtonEventType = (typeof ButtonEventType)[keyof typeof ButtonEventType];

/**
 * Gestures a Myo armband distinguishes.
 *
 * `ubii.dataStructure.HandGestureType`
 */
export const HandGestureType = {
  /** The hand is relaxed. */
  REST: 0,
  /** Fingers stretched apart. */
  FINGERS_SPREAD: 1,
  /** Hand bent inwards. */
  WAVE_IN: 2,
  /** Hand bent outwards. */
  WAVE_OUT: 3,
  /** Hand closed. */
  FIST: 4,
  /** Thumb and middle finger tapped together twice. */
  DOUBLE_TAP: 5,
} as const;
export type HandGestureType = (typeof HandGestureType)[keyof typeof HandGestureType];

/**
 * Layout of one pixel in the data; one byte a channel.
 *
 * `ubii.dataStructure.Image2D.DataFormat`
 */
export const Image2DDataFormat = {
  /** 1 channel: brightness. */
  GRAY8: 0,
  /** 3 channels: red, green, blue. */
  RGB8: 1,
  /** 4 channels: red, green, blue, opacity (not premultiplied). */
  RGBA8: 2,
} as const;
export type Image2DDataFormat = (typeof Image2DDataFormat)[keyof typeof Image2DDataFormat];

/**
 * What the finger did.
 *
 * `ubii.dataStructure.TouchEvent.TouchEventType`
 */
export const TouchEventType = {
  /** It came down. */
  TOUCH_START: 0,
  /** It moved. */
  TOUCH_MOVE: 1,
  /** It left, or the system took the touch away. */
  TOUCH_END: 2,
} as const;
export type TouchEventType = (typeof TouchEventType)[keyof typeof TouchEventType];

/**
 * Which way the data flows, seen from the device.
 *
 * `ubii.devices.Component.IOType`
 */
export const ComponentIOType = {
  /** The device publishes on the topic. */
  PUBLISHER: 0,
  /** The device subscribes to the topic. */
  SUBSCRIBER: 1,
} as const;
export type ComponentIOType = (typeof ComponentIOType)[keyof typeof ComponentIOType];

/**
 * What the device is for.
 *
 * `ubii.devices.Device.DeviceType`
 */
export const DeviceType = {
  /** It takes part: publishes and subscribes through its components. */
  PARTICIPANT: 0,
  /** It looks on: its client receives every topic. */
  WATCHER: 1,
} as const;
export type DeviceType = (typeof DeviceType)[keyof typeof DeviceType];

/**
 * Role of a caller: its rights. Rules AC-20 to AC-25.
 *
 * `ubii.extension.AccessRole`
 */
export const AccessRole = {
  /** No rights: a caller that has not joined. */
  ACCESS_ROLE_NONE: 0,
  /** Everything. */
  ACCESS_ROLE_ADMIN: 1,
  /** Everything but administration, and publishing in the name of others. */
  ACCESS_ROLE_PARTICIPANT: 2,
  /** Its own devices and topics, and those topics that its invitation names. */
  ACCESS_ROLE_PLAYER: 3,
  /** See everything, change nothing. */
  ACCESS_ROLE_VIEWER: 4,
} as const;
export type AccessRole = (typeof AccessRole)[keyof typeof AccessRole];

/**
 * Whether an asset set can be loaded.
 *
 * `ubii.extension.AssetSetState`
 */
export const AssetSetState = {
  /** Unknown to a newer or older program. */
  ASSET_SET_STATE_UNSPECIFIED: 0,
  /** It is not there. */
  ASSET_SET_STATE_MISSING: 1,
  /** All files are as its manifest states. */
  ASSET_SET_STATE_PRESENT: 2,
  /** A file is missing, differs from the manifest, or cannot be read. */
  ASSET_SET_STATE_DAMAGED: 3,
} as const;
export type AssetSetState = (typeof AssetSetState)[keyof typeof AssetSetState];

/**
 * How the caller was admitted.
 *
 * `ubii.extension.AuditEntry.Way`
 */
export const AuditEntryWay = {
  /** With a token or code. */
  GRANT: 0,
  /** As a program of the master's own machine. */
  LOCAL: 1,
  /** As an existing client of a network that is admitted. */
  NETWORK: 2,
  /** As a caller that another master of the cluster admits without a token. Rule CU-28. */
  CLUSTER: 3,
} as const;
export type AuditEntryWay = (typeof AuditEntryWay)[keyof typeof AuditEntryWay];

/**
 * What became of mappings that a bridge was asked about. Rule BR-82.
 *
 * `ubii.extension.BridgeOutcome`
 */
export const BridgeOutcome = {
  /** Nothing was to be saved. */
  BRIDGE_OUTCOME_UNSPECIFIED: 0,
  /** They are saved, and apply. */
  BRIDGE_OUTCOME_SAVED: 1,
  /** They have problems, and nothing was saved. */
  BRIDGE_OUTCOME_REFUSED: 2,
  /** The mappings had changed since that revision, and nothing was saved. */
  BRIDGE_OUTCOME_CONFLICT: 3,
} as const;
export type BridgeOutcome = (typeof BridgeOutcome)[keyof typeof BridgeOutcome];

/**
 * How near the other end of the client's socket is.
 *
 * `ubii.extension.ClientActivity.AddressKind`
 */
export const ClientActivityAddressKind = {
  /** It has not had a socket yet. */
  UNKNOWN: 0,
  /** A program of the master's own machine, or a proxy there. */
  LOOPBACK: 1,
  /** A private or link-local network. */
  PRIVATE: 2,
  /** Any other address. */
  PUBLIC: 3,
} as const;
export type ClientActivityAddressKind = (typeof ClientActivityAddressKind)[keyof typeof ClientActivityAddressKind];

/**
 * Whether it is there.
 *
 * `ubii.extension.ClusterMaster.State`
 */
export const ClusterMasterState = {
  /** The master that says this. */
  SELF: 0,
  /** It is heard. */
  PRESENT: 1,
  /** It is not heard any more. */
  LOST: 2,
  /** It said that it ends. */
  ENDED: 3,
} as const;
export type ClusterMasterState = (typeof ClusterMasterState)[keyof typeof ClusterMasterState];

/**
 * Why a caller cannot join. Rule AC-12.
 *
 * `ubii.extension.JoinProblem`
 */
export const JoinProblem = {
  /** Nothing stands against it. */
  JOIN_PROBLEM_NONE: 0,
  /** No token was shown. */
  JOIN_PROBLEM_MISSING: 1,
  /** The token or code is unknown. */
  JOIN_PROBLEM_WRONG: 2,
  /** Its time is over. */
  JOIN_PROBLEM_EXPIRED: 3,
  /** The invitation was revoked. */
  JOIN_PROBLEM_REVOKED: 4,
  /** As many have joined with it as may. */
  JOIN_PROBLEM_USED: 5,
  /** Too many wrong codes were tried; a code is looked at again a minute later. */
  JOIN_PROBLEM_GUESSING: 6,
  /** Joined, but the role is too low for what was asked. */
  JOIN_PROBLEM_ROLE: 7,
} as const;
export type JoinProblem = (typeof JoinProblem)[keyof typeof JoinProblem];

/**
 * How bad it is, from worst to best.
 *
 * `ubii.extension.LogLevel`
 */
export const LogLevel = {
  /** Something broke that should not. */
  LOG_ERROR: 0,
  /** Something was refused or is going wrong; the master goes on. */
  LOG_WARN: 1,
  /** Information for the operator. */
  LOG_INFO: 2,
  /** Something that helps to find a fault. */
  LOG_DEBUG: 3,
} as const;
export type LogLevel = (typeof LogLevel)[keyof typeof LogLevel];

/**
 * Colour of a mark.
 *
 * `ubii.extension.MarkColour`
 */
export const MarkColour = {
  /** Not chosen. */
  MARK_COLOUR_NONE: 0,
  /** Coral. */
  MARK_COLOUR_CORAL: 1,
  /** Blue. */
  MARK_COLOUR_BLUE: 2,
  /** Yellow. */
  MARK_COLOUR_YELLOW: 3,
  /** Green. */
  MARK_COLOUR_GREEN: 4,
  /** Pink. */
  MARK_COLOUR_PINK: 5,
  /** Petrol. */
  MARK_COLOUR_PETROL: 6,
  /** Plum. */
  MARK_COLOUR_PLUM: 7,
  /** Sky. */
  MARK_COLOUR_SKY: 8,
  /** Lime. */
  MARK_COLOUR_LIME: 9,
  /** Chalk. */
  MARK_COLOUR_CHALK: 10,
  /** Brown. */
  MARK_COLOUR_BROWN: 11,
  /** Ink. */
  MARK_COLOUR_INK: 12,
} as const;
export type MarkColour = (typeof MarkColour)[keyof typeof MarkColour];

/**
 * Outline of a mark.
 *
 * `ubii.extension.MarkShape`
 */
export const MarkShape = {
  /** Not chosen. */
  MARK_SHAPE_NONE: 0,
  /** Circle. */
  MARK_SHAPE_CIRCLE: 1,
  /** Triangle. */
  MARK_SHAPE_TRIANGLE: 2,
  /** Square. */
  MARK_SHAPE_SQUARE: 3,
  /** Star. */
  MARK_SHAPE_STAR: 4,
  /** Diamond. */
  MARK_SHAPE_DIAMOND: 5,
  /** Cross. */
  MARK_SHAPE_CROSS: 6,
  /** Hexagon. */
  MARK_SHAPE_HEXAGON: 7,
  /** Drop. */
  MARK_SHAPE_DROP: 8,
  /** Ring. */
  MARK_SHAPE_RING: 9,
  /** Moon. */
  MARK_SHAPE_MOON: 10,
  /** Flower. */
  MARK_SHAPE_FLOWER: 11,
  /** Heart. */
  MARK_SHAPE_HEART: 12,
} as const;
export type MarkShape = (typeof MarkShape)[keyof typeof MarkShape];

/**
 * Which kind of network it leads through.
 *
 * `ubii.extension.MasterAddress.Kind`
 */
export const MasterAddressKind = {
  /** This machine only. */
  LOOPBACK: 0,
  /** Wireless network. */
  WIFI: 1,
  /** Wired network. */
  ETHERNET: 2,
  /** Network of virtual machines or containers, or a tunnel. */
  VIRTUAL: 3,
  /** The address that the operator named, such as that of a proxy. It has no interface. */
  PUBLIC: 4,
} as const;
export type MasterAddressKind = (typeof MasterAddressKind)[keyof typeof MasterAddressKind];

/**
 * What happened.
 *
 * `ubii.extension.ModuleEvent.Kind`
 */
export const ModuleEventKind = {
  /** Its code failed. */
  ERROR: 0,
  /** It wrote to its console. */
  LOG: 1,
  /** It was killed: over its time or its memory. */
  KILLED: 2,
  /** It was started again. */
  RESTARTED: 3,
  /** It was given up after too many restarts. */
  FAILED: 4,
  /** Outputs were refused. */
  REFUSED: 5,
  /** Its runs take longer than its mode leaves them. */
  OVERRUN: 6,
} as const;
export type ModuleEventKind = (typeof ModuleEventKind)[keyof typeof ModuleEventKind];

/**
 * Where the master has a module from.
 *
 * `ubii.extension.ModuleOrigin`
 */
export const ModuleOrigin = {
  /** Not said. */
  MODULE_ORIGIN_UNKNOWN: 0,
  /** It came with the program. */
  MODULE_ORIGIN_BUILT_IN: 1,
  /** From the operator's folder of modules. */
  MODULE_ORIGIN_FOLDER: 2,
  /** Stored through a service, or as a file in the data directory. */
  MODULE_ORIGIN_STORED: 3,
  /** A node has it. */
  MODULE_ORIGIN_NODE: 4,
} as const;
export type ModuleOrigin = (typeof ModuleOrigin)[keyof typeof ModuleOrigin];

/**
 * Where a version is from.
 *
 * `ubii.extension.ModuleVersion.Origin`
 */
export const ModuleVersionOrigin = {
  /** A service call saved it. */
  SAVED: 0,
  /** The file was changed on disk. */
  FILE: 1,
  /** It was there when the history began. */
  FOUND: 2,
} as const;
export type ModuleVersionOrigin = (typeof ModuleVersionOrigin)[keyof typeof ModuleVersionOrigin];

/**
 * What tells the elements of a multiplexer apart. Rule PM-43.
 *
 * `ubii.extension.MuxIdentity`
 */
export const MuxIdentity = {
  /** What TopicMux.identity_match_pattern finds in the topic; without a pattern, what can be deduced. */
  MUX_IDENTITY_PATTERN: 0,
  /** Id of the client that published the record. */
  MUX_IDENTITY_CLIENT_ID: 1,
  /** Id of the device whose component has the topic. */
  MUX_IDENTITY_DEVICE_ID: 2,
  /** The whole topic. */
  MUX_IDENTITY_TOPIC: 3,
} as const;
export type MuxIdentity = (typeof MuxIdentity)[keyof typeof MuxIdentity];

/**
 * What kind of program runs the modules.
 *
 * `ubii.extension.NodeExtension.Kind`
 */
export const NodeExtensionKind = {
  /** Unspecified: a client of an older protocol, or one that runs no modules. */
  EXTERNAL: 0,
  /** The master itself. */
  MASTER: 1,
  /** A dedicated Node process. */
  NODE: 2,
  /** A browser tab. */
  BROWSER: 3,
} as const;
export type NodeExtensionKind = (typeof NodeExtensionKind)[keyof typeof NodeExtensionKind];

/**
 * What happens to a personal value when a recording is shared. Rule PD-2.
 *
 * `ubii.extension.PersonalTreatment`
 */
export const PersonalTreatment = {
  /** The value is left out; without a field path, the whole topic. */
  PERSONAL_TREATMENT_DROP: 0,
  /** The value is replaced by a pseudonym: the same value by the same one, as long as the key is the same. */
  PERSONAL_TREATMENT_PSEUDONYM: 1,
  /** Numbers are rounded to multiples of step. */
  PERSONAL_TREATMENT_ROUND: 2,
} as const;
export type PersonalTreatment = (typeof PersonalTreatment)[keyof typeof PersonalTreatment];

/**
 * Where a recording came from. Rule RC-1.
 *
 * `ubii.extension.RecordingKind`
 */
export const RecordingKind = {
  /** It was started, and stopped. */
  RECORDING_KIND_RECORDING: 0,
  /** It was kept from the flight recorder. */
  RECORDING_KIND_FLIGHT_RECORDER: 1,
  /** It was uploaded; other programs may have written it. */
  RECORDING_KIND_IMPORT: 2,
  /** It has the outputs of a recorded session that ran again on replayed inputs. Rule RP-40. */
  RECORDING_KIND_COMPARISON: 3,
} as const;
export type RecordingKind = (typeof RecordingKind)[keyof typeof RecordingKind];

/**
 * Where a recording is in its life. Rule RC-2.
 *
 * `ubii.extension.RecordingState`
 */
export const RecordingState = {
  /** Unknown to a newer or older program. */
  RECORDING_STATE_UNSPECIFIED: 0,
  /** Its file is being written. */
  RECORDING_STATE_RECORDING: 1,
  /** Its file is closed and whole. */
  RECORDING_STATE_COMPLETE: 2,
  /** The program that wrote it ended early; the master repaired the file, and the last second may be missing. */
  RECORDING_STATE_REPAIRED: 3,
  /** It ended early, such as on a full disk; what was written until then can be read. */
  RECORDING_STATE_FAILED: 4,
  /**
   * Its file is closed, and is still on the node that recorded it: problem says why, unless it is on its way. Rule
   * RC-63.
   */
  RECORDING_STATE_AT_NODE: 5,
  /**
   * Its file was refused when the master checked it: problem says why. It is kept under another name, is not read any
   * more, and can be deleted. Rule RC-45.
   */
  RECORDING_STATE_REJECTED: 6,
} as const;
export type RecordingState = (typeof RecordingState)[keyof typeof RecordingState];

/**
 * Whether a replay should play.
 *
 * `ubii.extension.ReplayAction`
 */
export const ReplayAction = {
  /** As it is. */
  REPLAY_ACTION_NONE: 0,
  /** Goes on; from the start of the span when it is at its end. */
  REPLAY_ACTION_PLAY: 1,
  /** Stands. */
  REPLAY_ACTION_PAUSE: 2,
} as const;
export type ReplayAction = (typeof ReplayAction)[keyof typeof ReplayAction];

/**
 * What happens to records that other clients publish on topics of a replay. Rules RP-20 to RP-22.
 *
 * `ubii.extension.ReplayConflict`
 */
export const ReplayConflict = {
  /** They are dropped. */
  REPLAY_CONFLICT_MUTE_LIVE: 0,
  /** They are published below a prefix of their own. */
  REPLAY_CONFLICT_MOVE_LIVE: 1,
  /** They are published as they are, among those of the replay. */
  REPLAY_CONFLICT_KEEP_LIVE: 2,
} as const;
export type ReplayConflict = (typeof ReplayConflict)[keyof typeof ReplayConflict];

/**
 * Where a replay is in its life. Rule RP-2.
 *
 * `ubii.extension.ReplayState`
 */
export const ReplayState = {
  /** Unknown to a newer or older program. */
  REPLAY_STATE_UNSPECIFIED: 0,
  /** It publishes. */
  REPLAY_STATE_PLAYING: 1,
  /** It stands. */
  REPLAY_STATE_PAUSED: 2,
  /** It stands at its end. */
  REPLAY_STATE_ENDED: 3,
  /** Its recording could not be read; problem says why. A change of it tries again. */
  REPLAY_STATE_FAILED: 4,
} as const;
export type ReplayState = (typeof ReplayState)[keyof typeof ReplayState];

/**
 * What becomes of what was made with an invitation that is revoked. Rule AC-92.
 *
 * `ubii.extension.RevokedWork`
 */
export const RevokedWork = {
  /** Sessions stop, and are kept as they are: other clients may start them. */
  REVOKED_WORK_STOP: 0,
  /** It becomes the operator's: sessions go on. */
  REVOKED_WORK_HAND_OVER: 1,
} as const;
export type RevokedWork = (typeof RevokedWork)[keyof typeof RevokedWork];

/**
 * Where a session is in its life, finer than SessionStatus. Rule SE-10.
 *
 * `ubii.extension.SessionState`
 */
export const SessionState = {
  /** Known, not started. */
  SESSION_CREATED: 0,
  /** Its modules are being made. */
  SESSION_STARTING: 1,
  /** All its modules run. */
  SESSION_RUNNING: 2,
  /** It runs, but not all of its modules do. */
  SESSION_DEGRADED: 3,
  /** Held; the modules keep their state. */
  SESSION_PAUSED: 4,
  /** Its modules are being ended. */
  SESSION_STOPPING: 5,
  /** Over; it can be started again. */
  SESSION_STOPPED: 6,
} as const;
export type SessionState = (typeof SessionState)[keyof typeof SessionState];

/**
 * What happened.
 *
 * `ubii.extension.StatusEvent.Kind`
 */
export const StatusEventKind = {
  /** A client registered. */
  CLIENT_JOINED: 0,
  /** A client deregistered. */
  CLIENT_LEFT: 1,
  /** A client became UNAVAILABLE. */
  CLIENT_LOST: 2,
  /** A client became ACTIVE again. */
  CLIENT_RETURNED: 3,
  /** Something was refused because of a limit. */
  LIMIT_REACHED: 4,
  /** The master started. */
  MASTER_STARTED: 5,
  /** A stored session or module was changed by hand and can be used. */
  FILE_CHANGED: 6,
  /** A stored session or module cannot be read. */
  FILE_BROKEN: 7,
  /** A session runs without some of its modules. */
  SESSION_DEGRADED: 8,
  /** A client was renamed. */
  CLIENT_RENAMED: 9,
  /** A client was disconnected by another client. */
  CLIENT_DISCONNECTED: 10,
  /** A client was throttled, or its throttle was changed or lifted. */
  CLIENT_THROTTLED: 11,
  /** The master, a publisher or a module takes more than the machine can give. Rule EX-45. */
  OVERLOAD: 12,
  /** Another master of the cluster is there. */
  MASTER_JOINED: 13,
  /** Another master of the cluster ended, or is not heard any more. */
  MASTER_LOST: 14,
  /** A session is run by another master than before. */
  SESSION_MOVED: 15,
} as const;
export type StatusEventKind = (typeof StatusEventKind)[keyof typeof StatusEventKind];

/**
 * How bad it is.
 *
 * `ubii.extension.StatusProblem.Severity`
 */
export const StatusProblemSeverity = {
  /** Works, but not as it should. */
  WARNING: 0,
  /** Does not work. */
  ERROR: 1,
} as const;
export type StatusProblemSeverity = (typeof StatusProblemSeverity)[keyof typeof StatusProblemSeverity];

/**
 * Where a block is in its life. Rule ST-21.
 *
 * `ubii.extension.StudyBlockState`
 */
export const StudyBlockState = {
  /** It has not begun, or is to be repeated. */
  STUDY_BLOCK_STATE_PENDING: 0,
  /** It runs. */
  STUDY_BLOCK_STATE_RUNNING: 1,
  /** It ended. */
  STUDY_BLOCK_STATE_DONE: 2,
  /** It was skipped. */
  STUDY_BLOCK_STATE_SKIPPED: 3,
  /** The master exited while it ran; it can be repeated. */
  STUDY_BLOCK_STATE_INTERRUPTED: 4,
} as const;
export type StudyBlockState = (typeof StudyBlockState)[keyof typeof StudyBlockState];

/**
 * What is checked of a required device.
 *
 * `ubii.extension.StudyCheckKind`
 */
export const StudyCheckKind = {
  /** That as many as needed are there. */
  STUDY_CHECK_KIND_PRESENCE: 0,
  /** Records per second. */
  STUDY_CHECK_KIND_RATE: 1,
  /** Charge. */
  STUDY_CHECK_KIND_BATTERY: 2,
  /** Clock error. */
  STUDY_CHECK_KIND_CLOCK: 3,
} as const;
export type StudyCheckKind = (typeof StudyCheckKind)[keyof typeof StudyCheckKind];

/**
 * What is known of one requirement. Rule ST-30.
 *
 * `ubii.extension.StudyCheckState`
 */
export const StudyCheckState = {
  /** Fulfilled. */
  STUDY_CHECK_STATE_OK: 0,
  /** Not there, or not known. */
  STUDY_CHECK_STATE_MISSING: 1,
  /** There, and not enough. */
  STUDY_CHECK_STATE_LOW: 2,
} as const;
export type StudyCheckState = (typeof StudyCheckState)[keyof typeof StudyCheckState];

/**
 * How the conditions of a study are ordered for a participant. Rule ST-10.
 *
 * `ubii.extension.StudyOrder`
 */
export const StudyOrder = {
  /** As the study lists them. */
  STUDY_ORDER_FIXED: 0,
  /** Shuffled for each participant, visit and repetition. */
  STUDY_ORDER_RANDOM: 1,
  /** By a balanced Latin square: over participants, each condition comes equally often at each position and after each other one. */
  STUDY_ORDER_BALANCED: 2,
} as const;
export type StudyOrder = (typeof StudyOrder)[keyof typeof StudyOrder];

/**
 * What to do with a run. Rules ST-21 to ST-25.
 *
 * `ubii.extension.StudyRunAction`
 */
export const StudyRunAction = {
  /** Unknown to a newer or older program. */
  STUDY_RUN_ACTION_UNSPECIFIED: 0,
  /** The participant consented to the text with consent_version. */
  STUDY_RUN_ACTION_CONSENT: 1,
  /** Begins a block: starts its recording and its session. */
  STUDY_RUN_ACTION_BEGIN_BLOCK: 2,
  /** Ends the block that runs. */
  STUDY_RUN_ACTION_END_BLOCK: 3,
  /** Skips a block that is pending or was interrupted. */
  STUDY_RUN_ACTION_SKIP_BLOCK: 4,
  /** Makes a block pending that is done, skipped or interrupted. Its recordings stay. */
  STUDY_RUN_ACTION_REPEAT_BLOCK: 5,
  /** Adds a note. During a block, it is a marker of the recording as well. */
  STUDY_RUN_ACTION_NOTE: 6,
  /** Ends the run, and the block that runs. */
  STUDY_RUN_ACTION_END: 7,
  /** Opens a run again that was interrupted or ended. */
  STUDY_RUN_ACTION_CONTINUE: 8,
} as const;
export type StudyRunAction = (typeof StudyRunAction)[keyof typeof StudyRunAction];

/**
 * Where a run is in its life. Rule ST-20.
 *
 * `ubii.extension.StudyRunState`
 */
export const StudyRunState = {
  /** Unknown to a newer or older program. */
  STUDY_RUN_STATE_UNSPECIFIED: 0,
  /** Blocks can begin. */
  STUDY_RUN_STATE_OPEN: 1,
  /** The master exited while it was open; it can be continued. */
  STUDY_RUN_STATE_INTERRUPTED: 2,
  /** It was ended. */
  STUDY_RUN_STATE_ENDED: 3,
} as const;
export type StudyRunState = (typeof StudyRunState)[keyof typeof StudyRunState];

/**
 * What the callbacks are written in. Only nodes of that language can run it.
 *
 * `ubii.processing.ProcessingModule.Language`
 */
export const ProcessingModuleLanguage = {
  /** C++; also what clients send that mean none, so an explicit 0 is never written. */
  CPP: 0,
  /** Python. */
  PY: 1,
  /** JavaScript. */
  JS: 2,
  /** C#. */
  CS: 3,
  /** Java. */
  JAVA: 4,
} as const;
export type ProcessingModuleLanguage = (typeof ProcessingModuleLanguage)[keyof typeof ProcessingModuleLanguage];

/**
 * Where it is in its life.
 *
 * `ubii.processing.ProcessingModule.Status`
 */
export const ProcessingModuleStatus = {
  /** Known, not yet made. */
  INITIALIZED: 0,
  /** Made, its onCreated has run. */
  CREATED: 1,
  /** Runs as its mode says. */
  PROCESSING: 2,
  /** Stopped, its state is kept. */
  HALTED: 3,
  /** Gone. */
  DESTROYED: 4,
} as const;
export type ProcessingModuleStatus = (typeof ProcessingModuleStatus)[keyof typeof ProcessingModuleStatus];

/**
 * Where a session is in its life.
 *
 * `ubii.sessions.SessionStatus`
 */
export const SessionStatus = {
  /** Known, not started, or on its way. */
  CREATED: 0,
  /** All its modules run. */
  RUNNING: 1,
  /** Held; the modules keep their state. */
  PAUSED: 2,
  /** Over; it can be started again. */
  STOPPED: 3,
} as const;
export type SessionStatus = (typeof SessionStatus)[keyof typeof SessionStatus];

/**
 * A process that takes part: it registers, publishes and subscribes, offers devices and modules.
 * Also used as a profile that clients are compared with in lists: there, empty members are ignored.
 *
 * `ubii.clients.Client`
 */
export interface Client {
  /** UUID, assigned by the master at registration. */
  id: string;
  /** Display name; need not be unique. */
  name: string;
  /** Its devices. */
  devices: Device[];
  /** Words to find it by. */
  tags: string[];
  /** Text for display. */
  description: string;
  /** Modules this client can run. */
  processingModules: ProcessingModule[];
  /** True when it exists to run modules for others. */
  isDedicatedProcessingNode: boolean;
  /** Address of the machine it runs on, as it sees it; informative. */
  hostIp: string;
  /** Anything else about it, as JSON text. */
  metadataJson: string;
  /** Set by the master. */
  state: ClientState;
  /** From a ping of the master to the answer, milliseconds; 0 before the first. Set by the master. */
  latency: number;
  /** What only clients and masters of this project tell each other; absent for all others. */
  extension: ClientExtension | undefined;
}

/**
 * Clients.
 *
 * `ubii.clients.ClientList`
 */
export interface ClientList {
  /** In no promised order. */
  elements: Client[];
}

/**
 * A rule on whether a record reaches a subscriber. Kept for compatibility: no master evaluates it.
 *
 * `ubii.conditions.NotifyCondition`
 */
export interface NotifyCondition {
  /** UUID, assigned by the master. */
  id: string;
  /** Text for display. */
  name: string;
  /** JavaScript function of publisher, subscriber and a way to read topics; true lets a record through. */
  evaluationFunctionStringified: string;
  /** Publishers it applies to, as a profile. */
  clientProfilePub: Client | undefined;
  /** Subscribers it applies to, as a profile. */
  clientProfileSub: Client | undefined;
}

/**
 * Truth values.
 *
 * `ubii.dataStructure.BoolList`
 */
export interface BoolList {
  /** In the publisher's order. */
  elements: boolean[];
}

/**
 * A colour with opacity, sRGB, each part from 0 to 1.
 *
 * `ubii.dataStructure.Color`
 */
export interface Color {
  /** Red. */
  r: number;
  /** Green. */
  g: number;
  /** Blue. */
  b: number;
  /** Opacity: 0 is invisible, 1 opaque. */
  a: number;
}

/**
 * Numbers of double precision.
 *
 * `ubii.dataStructure.DoubleList`
 */
export interface DoubleList {
  /** In the publisher's order; units are the publisher's. */
  elements: number[];
}

/**
 * Numbers of single precision.
 *
 * `ubii.dataStructure.FloatList`
 */
export interface FloatList {
  /** In the publisher's order; units are the publisher's. */
  elements: number[];
}

/**
 * A picture.
 *
 * `ubii.dataStructure.Image2D`
 */
export interface Image2D {
  /** Pixels in a row. */
  width: number;
  /** Rows. */
  height: number;
  /** Layout of a pixel; means nothing when the data is compressed. */
  dataFormat: Image2DDataFormat;
  /**
   * Pixels row by row from the top left without gaps: width * height * channels bytes. Some clients
   * put a JPEG, PNG or WebP file here; it is known by its first bytes.
   */
  data: Uint8Array;
}

/**
 * Pictures.
 *
 * `ubii.dataStructure.Image2DList`
 */
export interface Image2DList {
  /** In the publisher's order. */
  elements: Image2D[];
}

/**
 * Integers of 32 bits.
 *
 * `ubii.dataStructure.Int32List`
 */
export interface Int32List {
  /** In the publisher's order; units are the publisher's. */
  elements: number[];
}

/**
 * A key of a keyboard, or a named button of a controller, was pressed or released.
 *
 * `ubii.dataStructure.KeyEvent`
 */
export interface KeyEvent {
  /** Pressed or released. */
  type: ButtonEventType;
  /** Name of the key, in browsers the value of KeyboardEvent.key. */
  key: string;
}

/**
 * A matrix of 3 rows and 2 columns; the first digit is the row, the second the column. As a transform
 * of the plane, rows 0 and 1 are the images of the axes, row 2 is the translation.
 *
 * `ubii.dataStructure.Matrix3x2`
 */
export interface Matrix3x2 {
  /** Row 0, column 0. */
  m00: number;
  /** Row 0, column 1. */
  m01: number;
  /** Row 1, column 0. */
  m10: number;
  /** Row 1, column 1. */
  m11: number;
  /** Row 2, column 0. */
  m20: number;
  /** Row 2, column 1. */
  m21: number;
}

/**
 * A matrix of 4 rows and 4 columns; the first digit is the row, the second the column. Which side
 * vectors are multiplied on is agreed between publisher and subscriber.
 *
 * `ubii.dataStructure.Matrix4x4`
 */
export interface Matrix4x4 {
  /** Row 0, column 0. */
  m00: number;
  /** Row 0, column 1. */
  m01: number;
  /** Row 0, column 2. */
  m02: number;
  /** Row 0, column 3. */
  m03: number;
  /** Row 1, column 0. */
  m10: number;
  /** Row 1, column 1. */
  m11: number;
  /** Row 1, column 2. */
  m12: number;
  /** Row 1, column 3. */
  m13: number;
  /** Row 2, column 0. */
  m20: number;
  /** Row 2, column 1. */
  m21: number;
  /** Row 2, column 2. */
  m22: number;
  /** Row 2, column 3. */
  m23: number;
  /** Row 3, column 0. */
  m30: number;
  /** Row 3, column 1. */
  m31: number;
  /** Row 3, column 2. */
  m32: number;
  /** Row 3, column 3. */
  m33: number;
}

/**
 * A mouse button was pressed or released.
 *
 * `ubii.dataStructure.MouseEvent`
 */
export interface MouseEventMessage {
  /** Pressed or released. */
  type: ButtonEventType;
  /** Number of the button, in browsers MouseEvent.button: 0 main, 1 wheel, 2 secondary. */
  button: number;
}

/**
 * One measurement of a Myo armband.
 *
 * `ubii.dataStructure.MyoEvent`
 */
export interface MyoEvent {
  /** Muscle activity at the 8 electrodes, raw units of the device, -128 to 127. */
  emg: Vector8 | undefined;
  /** Rotation of the forearm. */
  orientation: Quaternion | undefined;
  /** Angular velocity about the axes of the armband, degrees per second. */
  gyroscope: Vector3 | undefined;
  /** Acceleration along the axes of the armband with gravity, in g (9.81 m/s^2). */
  accelerometer: Vector3 | undefined;
  /** What the hand does. */
  gesture: HandGestureType;
}

/**
 * A thing in the plane or in a picture.
 *
 * `ubii.dataStructure.Object2D`
 */
export interface Object2D {
  /** Which thing it is: a name, a number, or the class a detector found. Not unique in a list. */
  id: string;
  /** Where it is. */
  pose: Pose2D | undefined;
  /** How large it is along its axes, in the units of the position. */
  size: Vector2 | undefined;
  /** Anything else about it, as JSON text. */
  userDataJson: string;
}

/**
 * Things in the plane or in a picture.
 *
 * `ubii.dataStructure.Object2DList`
 */
export interface Object2DList {
  /** In the publisher's order. */
  elements: Object2D[];
}

/**
 * A thing in space.
 *
 * `ubii.dataStructure.Object3D`
 */
export interface Object3D {
  /** Which thing it is: a name, a number, or the class a detector found. Not unique in a list. */
  id: string;
  /** Where it is. */
  pose: Pose3D | undefined;
  /** How large it is along its axes, in the units of the position. */
  size: Vector3 | undefined;
  /** Anything else about it, as JSON text. */
  userDataJson: string;
}

/**
 * Things in space.
 *
 * `ubii.dataStructure.Object3DList`
 */
export interface Object3DList {
  /** In the publisher's order. */
  elements: Object3D[];
}

/**
 * Position and orientation in the plane.
 *
 * `ubii.dataStructure.Pose2D`
 */
export interface Pose2D {
  /** Where it is. In pictures from 0 to 1 of width and height, from the top left. */
  position: Vector2 | undefined;
  /** As a vector; its length means nothing. */
  direction?: Vector2 | undefined;
  /** As an angle from the x axis towards the y axis, radians. */
  angle?: number | undefined;
}

/**
 * Position and orientation in space. Frame and handedness are agreed between publisher and subscriber.
 *
 * `ubii.dataStructure.Pose3D`
 */
export interface Pose3D {
  /** Where it is, metres unless agreed otherwise. */
  position: Vector3 | undefined;
  /** As a unit quaternion. */
  quaternion?: Quaternion | undefined;
  /** As angles about the axes; unit and order are agreed between publisher and subscriber. */
  euler?: Vector3 | undefined;
}

/**
 * A rotation in space: w + xi + yj + zk. No rotation is w = 1 and the rest 0.
 *
 * `ubii.dataStructure.Quaternion`
 */
export interface Quaternion {
  /** First part of the vector: axis x times the sine of half the angle. */
  x: number;
  /** Second part of the vector. */
  y: number;
  /** Third part of the vector. */
  z: number;
  /** Scalar part: the cosine of half the angle. */
  w: number;
}

/**
 * Rotations in space. No record carries it: the member quaternion_list has the type Quaternion.
 *
 * `ubii.dataStructure.QuaternionList`
 */
export interface QuaternionList {
  /** In the publisher's order. */
  elements: Quaternion[];
}

/**
 * Texts.
 *
 * `ubii.dataStructure.StringList`
 */
export interface StringList {
  /** In the publisher's order. */
  elements: string[];
}

/**
 * A finger touched a surface, moved on it or left it.
 *
 * `ubii.dataStructure.TouchEvent`
 */
export interface TouchEventMessage {
  /** What the finger did. */
  type: TouchEventType;
  /** Where: from 0 to 1 of the surface's width and height, from the top left. */
  position: Vector2 | undefined;
  /** Tells fingers apart from start to end. */
  id: string;
  /** How hard, from 0 to 1; 0 when the device cannot tell. */
  force: number;
}

/**
 * Fingers that touch at the same time, or events since the list before.
 *
 * `ubii.dataStructure.TouchEventList`
 */
export interface TouchEventList {
  /** In the order they happened. */
  elements: TouchEventMessage[];
}

/**
 * 2 numbers; units and frame are agreed between publisher and subscriber.
 *
 * `ubii.dataStructure.Vector2`
 */
export interface Vector2 {
  /** Part 1 of 2. */
  x: number;
  /** Part 2 of 2. */
  y: number;
}

/**
 * Vectors of 2 numbers.
 *
 * `ubii.dataStructure.Vector2List`
 */
export interface Vector2List {
  /** In the publisher's order. */
  elements: Vector2[];
}

/**
 * 3 numbers; units and frame are agreed between publisher and subscriber.
 *
 * `ubii.dataStructure.Vector3`
 */
export interface Vector3 {
  /** Part 1 of 3. */
  x: number;
  /** Part 2 of 3. */
  y: number;
  /** Part 3 of 3. */
  z: number;
}

/**
 * Vectors of 3 numbers.
 *
 * `ubii.dataStructure.Vector3List`
 */
export interface Vector3List {
  /** In the publisher's order. */
  elements: Vector3[];
}

/**
 * 4 numbers; units and frame are agreed between publisher and subscriber.
 *
 * `ubii.dataStructure.Vector4`
 */
export interface Vector4 {
  /** Part 1 of 4. */
  x: number;
  /** Part 2 of 4. */
  y: number;
  /** Part 3 of 4. */
  z: number;
  /** Part 4 of 4. */
  w: number;
}

/**
 * Vectors of 4 numbers.
 *
 * `ubii.dataStructure.Vector4List`
 */
export interface Vector4List {
  /** In the publisher's order. */
  elements: Vector4[];
}

/**
 * 8 numbers, such as the electrodes of a Myo armband. No record carries it by itself.
 *
 * `ubii.dataStructure.Vector8`
 */
export interface Vector8 {
  /** Part 1 of 8. */
  v0: number;
  /** Part 2 of 8. */
  v1: number;
  /** Part 3 of 8. */
  v2: number;
  /** Part 4 of 8. */
  v3: number;
  /** Part 5 of 8. */
  v4: number;
  /** Part 6 of 8. */
  v5: number;
  /** Part 7 of 8. */
  v6: number;
  /** Part 8 of 8. */
  v7: number;
}

/**
 * Vectors of 8 numbers.
 *
 * `ubii.dataStructure.Vector8List`
 */
export interface Vector8List {
  /** In the publisher's order. */
  elements: Vector8[];
}

/**
 * One stream of data of a device: something it publishes or takes.
 * Also used as a profile that components are compared with: there, empty members are ignored.
 *
 * `ubii.devices.Component`
 */
export interface Component {
  /** Topic the data is on. */
  topic: string;
  /** Data format, by full or short name; existing devices use free spellings. */
  messageFormat: string;
  /** Direction. */
  ioType: ComponentIOType;
  /** Id of the device it belongs to. Set by the master. */
  deviceId: string;
  /** Words to find it by. */
  tags: string[];
  /** Text for display. */
  description: string;
  /** UUID; assigned by the master unless given. */
  id: string;
  /** Display name; unique within the device. */
  name: string;
  /** Ids of conditions under which its records are passed on; not evaluated. */
  notifyConditionIds: string[];
}

/**
 * Components.
 *
 * `ubii.devices.ComponentList`
 */
export interface ComponentList {
  /** In no promised order. */
  elements: Component[];
}

/**
 * A group of components that belong together, such as a phone, a headset or an avatar.
 * Also used as a profile that devices are compared with: there, empty members are ignored.
 *
 * `ubii.devices.Device`
 */
export interface Device {
  /** UUID; assigned by the master unless given. */
  id: string;
  /** Display name, and by convention the second part of its topics. */
  name: string;
  /** What it is for. */
  deviceType: DeviceType;
  /** Its streams of data, in the order of the registration. */
  components: Component[];
  /** Id of the client it belongs to. */
  clientId: string;
  /** Words to find it by. */
  tags: string[];
  /** Text for display. */
  description: string;
}

/**
 * Devices.
 *
 * `ubii.devices.DeviceList`
 */
export interface DeviceList {
  /** In no promised order. */
  elements: Device[];
}

/**
 * Spreads the list a module puts out over many topics.
 *
 * `ubii.devices.TopicDemux`
 */
export interface TopicDemux {
  /** UUID; existing nodes need it to be set. */
  id: string;
  /** Text for display. */
  name: string;
  /** Short name of the data format of the elements. */
  dataType: string;
  /** Topic with placeholders {{#0}}, {{#1}}, ... for the parameters that come with each element. */
  outputTopicFormat: string;
}

/**
 * Demultiplexers.
 *
 * `ubii.devices.TopicDemuxList`
 */
export interface TopicDemuxList {
  /** In no promised order. */
  elements: TopicDemux[];
}

/**
 * Gathers the newest records of many topics into one list for a module.
 *
 * `ubii.devices.TopicMux`
 */
export interface TopicMux {
  /** UUID; existing nodes need it to be set. */
  id: string;
  /** Text for display. */
  name: string;
  /** Short name of the data format it takes; empty takes all. */
  dataType: string;
  /** Regular expression that selects the topics, unanchored. */
  topicSelector: string;
  /** Regular expression; what it matches in a topic tells the elements apart. */
  identityMatchPattern: string;
  /** Glob that selects the topics, in place of the regular expression. Rule PM-41. */
  topicGlob: string;
  /** Selects the topics of the components that match it, in place of an expression. Rule PM-41. */
  component: Component | undefined;
  /** Where the identity comes from. Rule PM-43. */
  identitySource: MuxIdentity;
  /** Capture group of the identity pattern, from 1; 0 is the whole match. */
  identityGroup: number;
}

/**
 * Multiplexers.
 *
 * `ubii.devices.TopicMuxList`
 */
export interface TopicMuxList {
  /** In no promised order. */
  elements: TopicMux[];
}

/**
 * An invitation, made by an admin. Rules AC-10 to AC-16.
 *
 * `ubii.extension.AccessGrant`
 */
export interface AccessGrant {
  /** UUID, assigned by the master. */
  id: string;
  /** Label, for display. */
  label: string;
  /** Role of clients that join with it. */
  role: AccessRole;
  /** Path of the page that opens after joining, such as /devices/smart-device; empty for the start page. */
  target: string;
  /** When it was made: milliseconds since the Unix epoch, master's clock. */
  createdMs: number;
  /** When the invitation expires, the same clock. Clients that joined may stay until stays_until_ms. */
  expiresMs: number;
  /** How many may join with it; 0 for any number. */
  maxJoins: number;
  /** Players only: globs of topics they may subscribe to beside their own. */
  readTopics: string[];
  /** Players only: globs of topics they may publish on beside their own. */
  writeTopics: string[];
  /** When it was revoked, the same clock; 0 when it was not. */
  revokedMs: number;
  /** How many have joined with it. */
  joins: number;
  /** Ids of its clients that are registered now. */
  clientIds: string[];
  /** The master made it itself, for the code in its terminal. */
  isTerminal: boolean;
  /** When the short code ends, the same clock. */
  codeExpiresMs: number;
  /** Until when clients that joined may stay, the same clock. Rule AC-91. */
  staysUntilMs: number;
  /** Ids of sessions that its clients made or changed, and that are known now. Rule AC-90. */
  sessionIds: string[];
  /** Those of them that run. */
  runningSessionIds: string[];
  /** Names of stored sessions that its clients made or changed. */
  storedSessionNames: string[];
  /** Names of stored modules that its clients made or changed. */
  moduleNames: string[];
}

/**
 * Asks for an invitation. Rule AC-10.
 *
 * `ubii.extension.AccessGrantCreateRequest`
 */
export interface AccessGrantCreateRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Label for display, at most 100 characters on one line; may be empty. */
  label: string;
  /** Not ACCESS_ROLE_NONE. */
  role: AccessRole;
  /** Path of the page that opens after joining: begins with one slash; empty for the start page. */
  target: string;
  /** How long it can be joined with, milliseconds: at most 30 days; 0 for 12 hours. */
  lifetimeMs: number;
  /** How many may join with it; 0 for any number. */
  maxJoins: number;
  /** Players only: globs of topics they may subscribe to, at most 16. */
  readTopics: string[];
  /** Players only: globs of topics they may publish on, at most 16. */
  writeTopics: string[];
  /**
   * How long clients that join may stay, milliseconds from now: at most 30 days; as long as it can be joined
   * with when it is 0 or less than that. Rule AC-91.
   */
  stayMs: number;
}

/**
 * The invitation, with its secrets. They are shown this once. Rule AC-11.
 *
 * `ubii.extension.AccessGrantCreated`
 */
export interface AccessGrantCreated {
  /** The invitation. */
  grant: AccessGrant | undefined;
  /** The token: what stands in the QR code, as <origin>/join#<token>. */
  token: string;
  /** The code to type, such as K7QF-2MXR. */
  code: string;
}

/**
 * Invitations, without secrets.
 *
 * `ubii.extension.AccessGrantList`
 */
export interface AccessGrantList {
  /** The newest first. */
  elements: AccessGrant[];
}

/**
 * Revokes an invitation and disconnects all clients that joined with it. Rule AC-15.
 *
 * `ubii.extension.AccessGrantRevokeRequest`
 */
export interface AccessGrantRevokeRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Id of the invitation. */
  grantId: string;
  /** Why, for the persons it affects, a few words; may be empty. */
  reason: string;
  /** What becomes of what was made with it. */
  work: RevokedWork;
}

/**
 * One asset set: what the master has, or could download.
 *
 * `ubii.extension.AssetSet`
 */
export interface AssetSet {
  /** Name, as modules use it. */
  name: string;
  /** What it is, one sentence; empty when unknown, as the next three. */
  description: string;
  /** Version of its content. */
  version: string;
  /** SPDX expression. */
  licence: string;
  /** Where it comes from. */
  source: string;
  /** Bytes of all files. */
  bytes: number;
  /** Number of files. */
  files: number;
  /** Whether modules can load it. */
  state: AssetSetState;
  /** Why it is damaged, one sentence. */
  problem: string;
  /** True: it comes with the program. False: it belongs into the data directory. */
  bundled: boolean;
  /** Where the master downloads it from; empty when it cannot. */
  address: string;
  /** Absolute path of the folder that files can be put into; only for admins. */
  folder: string;
  /** The download under way, or the last one that failed. */
  download: AssetSetDownload | undefined;
  /** Where its publisher has the files; empty when unknown. */
  publisherAddress: string;
}

/**
 * How far a download is. Rule EX-58.
 *
 * `ubii.extension.AssetSetDownload`
 */
export interface AssetSetDownload {
  /** True while it is under way. */
  running: boolean;
  /** Bytes received. */
  loadedBytes: number;
  /** Bytes of all files. */
  totalBytes: number;
  /** Time since its start, milliseconds. */
  elapsedMs: number;
  /** Why it failed, one or two sentences; empty while it is under way. */
  error: string;
}

/**
 * The asset sets of a master. Rule EX-57.
 *
 * `ubii.extension.AssetSetList`
 */
export interface AssetSetList {
  /** By name. */
  elements: AssetSet[];
}

/**
 * Which asset set is to be downloaded, or is not any more. Rule EX-58.
 *
 * `ubii.extension.AssetSetRequest`
 */
export interface AssetSetRequest {
  /** Its name. */
  name: string;
}

/**
 * An action of a caller, done or refused.
 *
 * `ubii.extension.AuditEntry`
 */
export interface AuditEntry {
  /** Grows by one from entry to entry, over restarts of the master too. */
  number: number;
  /** Milliseconds since the Unix epoch, master's clock. */
  timeMs: number;
  /** Topic of the service. */
  service: string;
  /** What it was done to, for people: a name or id; empty when nothing was named. */
  object: string;
  /** Code of the error it was refused with; empty when it was done. */
  error: string;
  /** Id of the client that asked; empty when that is not known. */
  clientId: string;
  /** Its name then. */
  clientName: string;
  /** What it might do. */
  role: AccessRole;
  /** How it was admitted. */
  way: AuditEntryWay;
  /** Id of the invitation it joined with; empty when it needed none. */
  grantId: string;
  /** Label of that invitation. */
  grantLabel: string;
  /** How near it was; the address itself is not kept. */
  addressKind: ClientActivityAddressKind;
  /** Entries of the same caller that were left out before this one, because there were too many. */
  leftOut: number;
  /** Name of the master that the caller called, when that is another one of the cluster; empty for this one. */
  masterName: string;
}

/**
 * Entries of the audit log.
 *
 * `ubii.extension.AuditLog`
 */
export interface AuditLog {
  /** The newest first. */
  entries: AuditEntry[];
  /** There are older ones that fit. */
  more: boolean;
  /** Entries that are kept, whether or not they fit. */
  kept: number;
}

/**
 * Asks for entries of the audit log. Rules EX-90 to EX-95. What is empty is not looked at.
 *
 * `ubii.extension.AuditLogRequest`
 */
export interface AuditLogRequest {
  /** Entries with a smaller number are wanted; 0 for the newest. */
  before: number;
  /** Entries wanted at most: 1 to 500; 0 means 100. */
  count: number;
  /** Of this client. */
  clientId: string;
  /** Of clients that joined with this invitation. */
  grantId: string;
  /** Of services whose name contains this, such as session or access_grant_create. */
  service: string;
  /** With every word of this in what they say, in either case. */
  text: string;
}

/**
 * What a bridge answers to an order. Rule BR-80.
 *
 * `ubii.extension.BridgeAnswer`
 */
export interface BridgeAnswer {
  /** Number of the order. */
  number: number;
  /** The mappings. */
  mappings: BridgeMappings | undefined;
  /** Why it was refused; absent when it was not. */
  error: ErrorMessage | undefined;
}

/**
 * What is wrong with a mapping.
 *
 * `ubii.extension.BridgeMappingProblem`
 */
export interface BridgeMappingProblem {
  /** Index of the mapping; negative for the list as a whole. */
  index: number;
  /** Member of the mapping; empty for the mapping as a whole. */
  member: string;
  /** What is wrong, one sentence. */
  message: string;
}

/**
 * The mappings of a bridge. Rules BR-80 to BR-83.
 *
 * `ubii.extension.BridgeMappings`
 */
export interface BridgeMappings {
  /** Kind of the other system: mqtt, osc or rosbridge. */
  protocol: string;
  /** The mappings that apply now: the list of the mapping file, as JSON. Empty in the reply to a check. */
  mappingsJson: string;
  /** Changes with each change of the mapping file. */
  revision: string;
  /** Path of the mapping file on the computer of the bridge. */
  file: string;
  /** False: the file is created when mappings are saved for the first time. */
  fileExists: boolean;
  /** Why the file as it is now does not apply, as after an edit by hand; empty when it does. */
  fileProblem: string;
  /** What became of the request. */
  outcome: BridgeOutcome;
  /** What is wrong with the mappings of the request. */
  problems: BridgeMappingProblem[];
  /** What the previewed mapping selects of what there is. */
  matches: BridgeMatch[];
  /** Further matches, which are not listed. */
  moreMatches: number;
}

/**
 * Mappings that a bridge is to check or to save. Rules BR-81 and BR-82.
 *
 * `ubii.extension.BridgeMappingsChange`
 */
export interface BridgeMappingsChange {
  /** Id of the client that is the bridge. */
  targetId: string;
  /** All its mappings: the list of a mapping file, as JSON. */
  mappingsJson: string;
  /** Revision of the mappings that were changed. Checks do not need it. */
  revision: string;
  /** Of checks: which mapping is tried on what there is, by its index; a negative one for none. */
  previewIndex: number;
  /** Id of the client that asks; empty for a program that is none. */
  clientId: string;
}

/**
 * Asks for the mappings of a bridge. Rule BR-80.
 *
 * `ubii.extension.BridgeMappingsRequest`
 */
export interface BridgeMappingsRequest {
  /** Id of the client that is the bridge. */
  targetId: string;
}

/**
 * A topic or an address that a mapping selects.
 *
 * `ubii.extension.BridgeMatch`
 */
export interface BridgeMatch {
  /** True: from an address of the other system to a topic. */
  inward: boolean;
  /** What is selected. */
  source: string;
  /** What the mapping makes of it. */
  target: string;
  /** True: an example, because nothing that is there matches. */
  isExample: boolean;
}

/**
 * Something that the master asks a bridge, after it has checked who asks. Rule BR-80.
 *
 * `ubii.extension.BridgeOrder`
 */
export interface BridgeOrder {
  /** Number of the order, which the answer has, too. */
  number: number;
  /** Tell the mappings. */
  get?: BridgeMappingsRequest | undefined;
  /** Check mappings. */
  check?: BridgeMappingsChange | undefined;
  /** Save mappings. */
  set?: BridgeMappingsChange | undefined;
  /** Name of the client that asks. */
  author: string;
}

/**
 * What one client does. Counts are totals since it registered; rates are those of the last measurement.
 *
 * `ubii.extension.ClientActivity`
 */
export interface ClientActivity {
  /** Id of the client. */
  clientId: string;
  /** When it registered: milliseconds since the Unix epoch, master's clock. */
  firstSeenMs: number;
  /** Its last activity, the same clock. Rule CL-11. */
  lastSeenMs: number;
  /** It has an open socket. */
  connected: boolean;
  /** Since when it has that socket, the same clock; 0 when it has none. */
  connectedMs: number;
  /** Time from the last PING to its PONG, milliseconds; 0 before the first. Rule CL-15. */
  roundTripMs: number;
  /** Age of that measurement, milliseconds; 0 when there was none. */
  roundTripAgeMs: number;
  /** Records it published. */
  recordsIn: number;
  /** Encoded bytes of them. */
  bytesIn: number;
  /** Records that were handed to its socket. */
  recordsOut: number;
  /** Encoded bytes of them. */
  bytesOut: number;
  /** Records it published a second. */
  recordsInPerSecond: number;
  /** Bytes of them a second. */
  bytesInPerSecond: number;
  /** Records handed to its socket a second. */
  recordsOutPerSecond: number;
  /** Bytes of them a second. */
  bytesOutPerSecond: number;
  /** Records that wait because its socket cannot take more. */
  queuedRecords: number;
  /** Bytes that wait: those records, and what the system has not taken from its socket. */
  queuedBytes: number;
  /** Records it did not get because it was too slow. */
  dropped: number;
  /** Records of its own that were refused: malformed, forbidden, over a limit or a throttle. */
  refused: number;
  /** Messages of its own that cannot be read. */
  protocolErrors: number;
  /** Subscriptions by topic. */
  topicSubscriptions: number;
  /** Subscriptions by regular expression. */
  patternSubscriptions: number;
  /** Subscriptions by component profile. */
  componentSubscriptions: number;
  /** One of its devices watches every topic. */
  watchesEverything: boolean;
  /** The subscriptions, when they were asked for; at most 1000. */
  subscriptions: ClientSubscription[];
  /** Topics that hold a value of its own. */
  ownedTopics: number;
  /** The User-Agent of its socket, at most 256 characters; empty when it sent none. */
  userAgent: string;
  /** What the client says of its library, at most 64 characters; empty when it says nothing. */
  library: string;
  /** Kind of its network address. The address itself is not sent. */
  addressKind: ClientActivityAddressKind;
  /** The throttle in force; absent when there is none. */
  throttle: ClientThrottle | undefined;
  /** Estimated share of the work of forwarding records that is on its account, 0 to 1. Rule EX-27. */
  workShare: number;
  /** What it may do. Rule AC-20. */
  role: AccessRole;
  /** Id of the invitation it joined with; empty when it needed none. */
  grantId: string;
  /** What the client says of its clock; absent when it says nothing. Rule TS-10. */
  clock: ClientClock | undefined;
  /**
   * The same for all clients whose sockets come from one address, or one IPv6 network of 64 bits; another after a restart
   * of the master. Empty before the first socket. Rule EX-99.
   */
  addressGroup: string;
}

/**
 * The clock of a client beside the master's, as the client measured it.
 *
 * `ubii.extension.ClientClock`
 */
export interface ClientClock {
  /** Master's clock minus the client's, milliseconds: above 0 the master is ahead. */
  offsetMs: number;
  /** How far the client's idea of the master's time may be from it, milliseconds. */
  errorMs: number;
  /** What the master's clock gains on the client's timer, parts per million. */
  driftPpm: number;
  /** Age of what the client said, milliseconds. */
  ageMs: number;
}

/**
 * Removes a client. Rule EX-30.
 *
 * `ubii.extension.ClientDisconnectRequest`
 */
export interface ClientDisconnectRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Id of the client to remove. */
  targetId: string;
  /** Why, for the person it affects, a few words; may be empty. */
  reason: string;
}

/**
 * What a client of this project and a master of this project tell each other at registration, beyond
 * what existing clients know. A client sends it to opt in; a master answers with it only to a client
 * that sent it. Rules EX-1 to EX-6.
 *
 * `ubii.extension.ClientExtension`
 */
export interface ClientExtension {
  /** Client to master: topic data may arrive as topic_data_record_list as well as single records. */
  recordLists: boolean;
  /**
   * Client to master: the token of an earlier registration, sent together with the earlier
   * Client.id, to come back as the same client; empty on a first registration.
   * Master to client: the token for this Client.id. A secret of the client, never listed.
   */
  resumeToken: string;
  /** Master to client: true when the client came back under the id it asked for. */
  resumed: boolean;
  /** Master to client: version of the master, semantic versioning. */
  masterVersion: string;
  /** Client to master: what it is as a node; absent when it runs no modules. Rule PM-60. */
  node: NodeExtension | undefined;
  /** Client to master: name and version of its library, such as client-web/0.1.0. Rule EX-25. */
  library: string;
  /**
   * Client to master: when it sent this, milliseconds since the Unix epoch by its own clock, but always more than in what
   * it sent before; 0 when it does not say. Rule EX-51.
   */
  sentMs: number;
  /**
   * Master to client: what shows later requests to come from this client, sent as
   * "Authorization: Bearer <credential>"; empty when it needs none. A secret of the client. Rule AC-13.
   */
  credential: string;
  /** Master to client: when the credential ends, milliseconds since the Unix epoch, master's clock. */
  credentialExpiresMs: number;
  /** Master to client: what the client may do. Rule AC-20. */
  role: AccessRole;
  /** Master to client: it answers a numbered PING with its time. Rule TS-1. */
  tellsTime: boolean;
  /**
   * Master to client: addresses of the other masters of its cluster, where it can come back when this one is lost; the
   * best of each first. Rule CU-26.
   */
  masters: string[];
  /**
   * Master to all, in lists, announcements and the reply to a registration: id of the master of the cluster that the client
   * is at, or was at when that master is lost; empty at a master that is alone. Rules CU-70 and CU-80.
   */
  masterId: string;
  /** Master to all, in an announcement: what is large was left out; client_get_list has it. Rule EX-74. */
  abridged: boolean;
  /** Master to all, in an abridged announcement: grows when what was left out changes. Rule EX-74. */
  registrationRevision: number;
  /**
   * Client to master: the mark it would have; absent when any will do. Master to all, in lists, announcements and the reply
   * to a registration: the mark it has. Rule EX-100.
   */
  mark: Mark | undefined;
}

/**
 * Renames a client. Rule EX-29.
 *
 * `ubii.extension.ClientRenameRequest`
 */
export interface ClientRenameRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Id of the client to rename. */
  targetId: string;
  /** The new display name. */
  name: string;
}

/**
 * What clients do, and what they take of the master.
 *
 * `ubii.extension.ClientReport`
 */
export interface ClientReport {
  /** When this was taken: milliseconds since the Unix epoch, master's clock. */
  masterTimeMs: number;
  /** The time over which rates and shares were measured, milliseconds; 0 before the first measurement. */
  measuredMs: number;
  /** The clients asked for that there are, in the order in which they registered. */
  clients: ClientActivity[];
}

/**
 * Asks what clients do. Rules EX-25 to EX-28.
 *
 * `ubii.extension.ClientReportRequest`
 */
export interface ClientReportRequest {
  /** Ids of the clients it is about; empty asks for all. */
  clientIds: string[];
  /** True: the subscriptions of each client are wanted as well, and not their number alone. */
  subscriptions: boolean;
}

/**
 * One subscription of a client. One of topic, pattern and component is set.
 *
 * `ubii.extension.ClientSubscription`
 */
export interface ClientSubscription {
  /** The topic. */
  topic: string;
  /** The regular expression. */
  pattern: string;
  /** The component profile. */
  component: Component | undefined;
  /** Records a second of one topic at most; 0 for every record. Rule TD-28. */
  maxRateHz: number;
}

/**
 * What keeps a client from publishing as much as it wants to. Rules EX-31 to EX-33.
 *
 * `ubii.extension.ClientThrottle`
 */
export interface ClientThrottle {
  /** Records it may publish a second, and at once. */
  recordsPerSecond: number;
  /** True: the master's own policy made it, and lifts it. Rule EX-48. */
  byPolicy: boolean;
  /** Name of the client that asked for it; empty when unknown. */
  byName: string;
  /** Reason; empty when none was given. */
  reason: string;
  /** Since when: milliseconds since the Unix epoch, master's clock. */
  sinceMs: number;
  /** Records that were dropped because of it. */
  dropped: number;
}

/**
 * Limits what a client publishes. Rules EX-31 to EX-33.
 *
 * `ubii.extension.ClientThrottleRequest`
 */
export interface ClientThrottleRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Id of the client to throttle. */
  targetId: string;
  /** Records it may publish a second, and at once; 0 lifts the throttle. */
  recordsPerSecond: number;
  /** Why, for the person it affects, a few words; may be empty. */
  reason: string;
}

/**
 * A service request that another master is to answer.
 *
 * `ubii.extension.ClusterCall`
 */
export interface ClusterCall {
  /** Number of the call, for its reply. */
  number: number;
  /** Encoded ServiceRequest. */
  request: Uint8Array;
  /** How the caller stands to the master that it called: trusted, local, network or other. */
  standing: string;
  /** Unit by which wrong codes of the caller are counted. */
  place: string;
  /** Its address, where place is a network. */
  address: string;
  /** The token, code or credential that it shows; empty without one. */
  bearer: string;
  /** It is on the machine of the master that it called. */
  isHere: boolean;
}

/**
 * A client of one master, for the others.
 *
 * `ubii.extension.ClusterClient`
 */
export interface ClusterClient {
  /** The client with its devices, without its extension. */
  client: Client | undefined;
  /** It sent an extension at registration. Rule EX-1. */
  isExtension: boolean;
  /** What it is as a node; absent when it runs no modules. */
  node: NodeExtension | undefined;
  /** Name and version of its library. */
  library: string;
  /** What it may do. */
  role: AccessRole;
  /** Id of the invitation it joined with; empty when it needed none. */
  grantId: string;
  /**
   * When it came to this master: milliseconds since the Unix epoch, by its own clock if it says (EX-51). The newest place
   * counts. Rule CU-22.
   */
  hereSinceMs: number;
  /** How it came in: local, network or grant. Rule AC-20. */
  accessKind: string;
}

/**
 * Bytes for a client, or from it.
 *
 * `ubii.extension.ClusterClientBytes`
 */
export interface ClusterClientBytes {
  /** Id of the client. */
  clientId: string;
  /** Encoded TopicData for it, or encoded NodeMessage of it. */
  bytes: Uint8Array;
}

/**
 * A master leaves the cluster.
 *
 * `ubii.extension.ClusterGoodbye`
 */
export interface ClusterGoodbye {
}

/**
 * A master of the cluster.
 *
 * `ubii.extension.ClusterHello`
 */
export interface ClusterHello {
  /** Version of these messages: masters of other versions are not listened to. */
  version: number;
  /** Name for people. */
  name: string;
  /** Addresses of its frontend for clients, best first. */
  addresses: string[];
  /** Version of its program, semantic versioning. */
  masterVersion: string;
  /** When it started: milliseconds since the Unix epoch, its own clock. */
  startedMs: number;
  /** Distinguishes its installation from others of the cluster, the same in later runs. Rule AC-43. */
  installation: string;
}

/**
 * What one master wants to receive of others. One of topic, pattern, profile and everything is set.
 *
 * `ubii.extension.ClusterInterest`
 */
export interface ClusterInterest {
  /** Records of this topic. */
  topic: string;
  /** Those of topics that match this regular expression. */
  pattern: string;
  /** Those of topics that this component profile selects. */
  profile: Component | undefined;
  /** Those of every topic. */
  everything: boolean;
  /** Records a second of one topic at most; 0 for every record. */
  maxRateHz: number;
}

/**
 * Asks a master for a stream.
 *
 * `ubii.extension.ClusterListen`
 */
export interface ClusterListen {
  /** Number that the parts of the new stream bear; the one before is over. */
  stream: number;
}

/**
 * A master of a cluster. Counts and rates are of what crosses between it and the master that says this; 0 for itself.
 *
 * `ubii.extension.ClusterMaster`
 */
export interface ClusterMaster {
  /** UUID of this run of the master, the same as Server.id. */
  id: string;
  /** Text for display. */
  name: string;
  /** Whether it is there. */
  state: ClusterMasterState;
  /** Since when: milliseconds since the Unix epoch, clock of the master that says this. */
  sinceMs: number;
  /** Version of its program, semantic versioning. */
  version: string;
  /** When it started: milliseconds since the Unix epoch, its own clock. */
  startedMs: number;
  /** Addresses of its frontend, best first. */
  addresses: string[];
  /** Clients at it that are ACTIVE or INACTIVE. */
  clients: number;
  /** Sessions that it runs. */
  sessions: number;
  /** Time to it and back through NATS, milliseconds; 0 before the first measurement. */
  roundTripMs: number;
  /** Records sent to it since it is there. */
  recordsTo: number;
  /** Records received from it since it is there. */
  recordsFrom: number;
  /** Records sent to it per second, in the last measurement. */
  recordsToPerSecond: number;
  /** Records received from it per second. */
  recordsFromPerSecond: number;
  /** Bytes of all messages sent to it per second. */
  bytesToPerSecond: number;
  /** Bytes of all messages received from it per second. */
  bytesFromPerSecond: number;
  /** Records that wait to be sent to it. */
  queuedRecords: number;
  /** Records that it did not get, because they could not be sent as fast as they were published. */
  dropped: number;
  /** Times that something was missing of what it sent. */
  gaps: number;
  /** All that it has was received. */
  complete: boolean;
}

/**
 * What the masters of a cluster tell each other. Rules CU-1 to CU-40.
 *
 * `ubii.extension.ClusterMessage`
 */
export interface ClusterMessage {
  /** To all: this master is there. Rule CU-2. */
  hello?: ClusterHello | undefined;
  /** To all: this master ends. Rule CU-3. */
  goodbye?: ClusterGoodbye | undefined;
  /** To one: begin to tell me what you have, from the start. Rule CU-5. */
  listen?: ClusterListen | undefined;
  /** To one: what it listens to. Rule CU-6. */
  part?: ClusterPart | undefined;
  /** To one: a service request of a client that is elsewhere. Rule CU-28. */
  call?: ClusterCall | undefined;
  /** To one: the reply to it. */
  reply?: ClusterReply | undefined;
  /**
   * Last of all: HMAC-SHA-256 of what stands before it, by which a master proves that it has the key of the cluster.
   * Parts with records and nothing else have none. Rule CU-65.
   */
  proof: Uint8Array;
}

/**
 * One message of a stream. Parts of a stream are numbered without gaps: one that is missing ends it.
 *
 * `ubii.extension.ClusterPart`
 */
export interface ClusterPart {
  /** The number that was asked for. */
  stream: number;
  /** Place in the stream, from 0. */
  number: number;
  /** Clients of this master that came or changed. */
  clients: ClusterClient[];
  /** Ids of its clients that are gone. */
  goneClients: string[];
  /** What clients of this master want to receive from now on. */
  wanted: ClusterInterest[];
  /** What they no longer want. */
  unwanted: ClusterInterest[];
  /** Values that stand, asked for by what was wanted. */
  values: ClusterRecords | undefined;
  /** Records that were just published. */
  records: ClusterRecords | undefined;
  /** All that was there when the stream began was told. */
  complete: boolean;
  /** What became of sessions that this master runs, in order. Rule CU-30. */
  sessionNews: ClusterSessionNews[];
  /** For clients of the master that listens, of whom this one runs modules. Rule CU-24. */
  frames: ClusterClientBytes[];
  /** From clients of this master, which are nodes. Rule CU-24. */
  nodeMessages: ClusterClientBytes[];
  /** In one part each half second: the clock of the sender, milliseconds from any start. Rule CU-74. */
  sentMs: number;
  /** Beside it: what the listener sent last as its own sent_ms; 0 when it sent none. */
  echoMs: number;
  /** How long ago that came, milliseconds. */
  heldMs: number;
}

/**
 * Encoded records, in publishing order. The lists stand side by side.
 *
 * `ubii.extension.ClusterRecords`
 */
export interface ClusterRecords {
  /** Encoded TopicDataRecords. */
  records: Uint8Array[];
  /** Stamp of each: what makes the newest of all masters the value of a topic. Rule CU-12. */
  stamps: number[];
  /** Place of the publisher of each in the list of their ids. */
  publishers: number[];
  /** Ids of publishers. */
  publisherIds: string[];
}

/**
 * The reply to a call.
 *
 * `ubii.extension.ClusterReply`
 */
export interface ClusterReply {
  /** Number of the call. */
  number: number;
  /** Encoded ServiceReply. */
  reply: Uint8Array;
}

/**
 * News of a session, for clients of other masters.
 *
 * `ubii.extension.ClusterSessionNews`
 */
export interface ClusterSessionNews {
  /** The topic on which it is told to clients; empty for a session as it is when the stream begins. */
  topic: string;
  /** The whole session. */
  session: Session | undefined;
}

/**
 * The cluster of a master, as that master sees it. Rules CU-72 to CU-75.
 *
 * `ubii.extension.ClusterStatus`
 */
export interface ClusterStatus {
  /** Name of the cluster. */
  name: string;
  /** NATS can be reached. While it cannot, this master is alone. */
  reachable: boolean;
  /** Since when that is so: milliseconds since the Unix epoch, master's clock. */
  reachableSinceMs: number;
  /** Bytes sent to other masters that NATS has not taken yet. */
  queuedBytes: number;
  /** Times since the start of this master that something was missing of what another one sent. */
  gaps: number;
  /** This master, then those that are there by name, then those that are not. */
  masters: ClusterMaster[];
}

/**
 * Topics that demuxers of a node made, and whose values end.
 *
 * `ubii.extension.EndedTopics`
 */
export interface EndedTopics {
  /** Topics of the node's client; others are left alone. */
  topics: string[];
}

/**
 * The flight recorder: the last minutes, in memory. Rules RC-30 to RC-33.
 *
 * `ubii.extension.FlightRecorder`
 */
export interface FlightRecorder {
  /** Whether it records. */
  isOn: boolean;
  /** Minutes it keeps at most. */
  minutes: number;
  /** Bytes it keeps at most. */
  maxBytes: number;
  /** Whether it keeps images. */
  withImages: boolean;
  /** From its oldest record to its newest, milliseconds. */
  heldMs: number;
  /** Bytes of its records. */
  heldBytes: number;
  /** Topics of its records. */
  topicCount: number;
  /** Records in it. */
  recordCount: number;
  /** Records per second, in slots of equal length over the minutes it keeps, oldest first. */
  recordsPerSecond: number[];
  /** Records it lost, because it could not take them in time, since the master started. */
  lostCount: number;
}

/**
 * Keeps what the flight recorder holds as a recording. Rule RC-32.
 *
 * `ubii.extension.FlightRecorderKeepRequest`
 */
export interface FlightRecorderKeepRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Name of the recording; empty for one made of date and time. */
  name: string;
  /** Notes, for display. */
  notes: string;
}

/**
 * Changes what the flight recorder keeps, until the master exits. Rule RC-31.
 *
 * `ubii.extension.FlightRecorderSettings`
 */
export interface FlightRecorderSettings {
  /** Whether it records; false drops what it holds. */
  isOn: boolean;
  /** Minutes it keeps at most; 0 to leave it as it is. */
  minutes: number;
  /** Bytes it keeps at most; 0 to leave it as it is. */
  maxBytes: number;
  /** Whether it keeps images. */
  withImages: boolean;
}

/**
 * Records of these topics, oldest first; the oldest ones are left out when they would be too many bytes. Rule RC-36.
 *
 * `ubii.extension.FlightRecords`
 */
export interface FlightRecords {
  /** When each record came, epoch milliseconds of the clock of the master. */
  timesMs: number[];
  /** Length of each record, bytes. */
  lengths: number[];
  /** The records one behind the other, each an encoded ubii.topicData.TopicDataRecord. */
  records: Uint8Array;
}

/**
 * Asks for what the flight recorder holds of some topics. Rule RC-36.
 *
 * `ubii.extension.FlightRecordsRequest`
 */
export interface FlightRecordsRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** The topics, without wildcards. */
  topics: string[];
  /** Records that came before this moment are left out, epoch milliseconds; 0 for all. */
  sinceMs: number;
}

/**
 * What a token is good for, or what the caller may do.
 *
 * `ubii.extension.JoinCheck`
 */
export interface JoinCheck {
  /** Role of clients that join with it; ACCESS_ROLE_NONE when it is not valid. */
  role: AccessRole;
  /** Why it is good for nothing. */
  problem: JoinProblem;
  /** One sentence for display: what is wrong and what to do; empty when nothing is wrong. */
  message: string;
  /** Path of the page that opens after joining; empty for the start page. */
  target: string;
  /**
   * Until when clients can join with it, or until when the credential of the caller is good:
   * milliseconds since the Unix epoch, master's clock; 0 when there is no end.
   */
  expiresMs: number;
  /** Name of the master, as it is displayed. */
  masterName: string;
  /** The caller has joined with it: joining once more changes nothing. */
  isJoined: boolean;
  /** A mark that no client here has. Rule EX-100. */
  freeMark: Mark | undefined;
  /** Marks of those who are here, but of the caller: one client for each mark. */
  takenMarks: TakenMark[];
}

/**
 * Checks a token or code before a client joins with it. Rule AC-16.
 *
 * `ubii.extension.JoinCheckRequest`
 */
export interface JoinCheckRequest {
  /** A token, or a code as it was typed. Empty: asks about the caller as it is. */
  token: string;
}

/**
 * Why a caller cannot join, as part of an error. Rule AC-12.
 *
 * `ubii.extension.JoinRefusal`
 */
export interface JoinRefusal {
  /** Not JOIN_PROBLEM_NONE. */
  problem: JoinProblem;
}

/**
 * One limit.
 *
 * `ubii.extension.Limit`
 */
export interface Limit {
  /** Name, as errors, metrics and problems show it. */
  name: string;
  /** What is allowed. */
  value: number;
  /** What the value counts: bytes, ms, topics, records/s, ... */
  unit: string;
  /** Why it is this number. */
  reason: string;
  /** The heading it stands under: messages, storage, subscriptions, rates, queues, sessions, time, statistics. */
  group: string;
  /** How near the master is to it; absent when that is not measured. */
  use: LimitUse | undefined;
  /** How often it was met since the master started. */
  hits: number;
}

/**
 * The limits a master runs with. Rules EX-35 and EX-36.
 *
 * `ubii.extension.LimitList`
 */
export interface LimitList {
  /** Each limit once, related ones together. */
  elements: Limit[];
}

/**
 * How near the master is to a limit.
 *
 * `ubii.extension.LimitUse`
 */
export interface LimitUse {
  /** Of a limit of the whole master, what is used; of one of each client or session, the largest use of any. */
  value: number;
  /** The client with that use; empty when the limit is not one of each client, or there is no use. */
  clientId: string;
  /** The session with that use; empty likewise. */
  sessionId: string;
}

/**
 * One value that belongs to a log line.
 *
 * `ubii.extension.LogField`
 */
export interface LogField {
  /** Its name, such as clientId. */
  name: string;
  /** Its value as text. */
  value: string;
}

/**
 * One line of the master's log.
 *
 * `ubii.extension.LogLine`
 */
export interface LogLine {
  /** Grows by one from line to line. */
  number: number;
  /** Milliseconds since the Unix epoch, master's clock. */
  timeMs: number;
  /** How bad it is. */
  level: LogLevel;
  /** What happened. */
  message: string;
  /** What belongs to it: names and values, in their order. */
  fields: LogField[];
}

/**
 * Asks for lines of the master's log. Rules EX-37 to EX-39.
 *
 * `ubii.extension.LogRequest`
 */
export interface LogRequest {
  /** Cursor of the reply the client already has; 0 asks for all that is kept. */
  cursor: number;
  /** The least severe lines that are wanted. */
  level: LogLevel;
  /** Lines wanted at most, the newest ones; 0 means 1000. */
  count: number;
}

/**
 * Lines of the master's log after the cursor of the request.
 *
 * `ubii.extension.LogTail`
 */
export interface LogTail {
  /** To be sent with the next request. */
  cursor: number;
  /** True when this is all there is: the cursor was 0 or of another run of the master. */
  reset: boolean;
  /**
   * Lines after the cursor, of any level, that are not in the list because they are kept no more or were
   * more than wanted.
   */
  missed: number;
  /** Oldest first. */
  lines: LogLine[];
}

/**
 * Shape and colour by which people tell clients apart. Rule EX-100.
 *
 * `ubii.extension.Mark`
 */
export interface Mark {
  /** Its outline. */
  shape: MarkShape;
  /** Its colour. */
  colour: MarkColour;
  /** Client to master: a person chose it, and it is taken also when another client has it. */
  chosen: boolean;
}

/**
 * One way to reach the master.
 *
 * `ubii.extension.MasterAddress`
 */
export interface MasterAddress {
  /** Which kind of network it leads through. */
  kind: MasterAddressKind;
  /** Name of the network interface as the system calls it. */
  interfaceName: string;
  /** http or https URL with port and without a path. */
  url: string;
}

/**
 * What only a master can compute that has the key of the cluster, and this address. Rule CU-85.
 *
 * `ubii.extension.MasterProof`
 */
export interface MasterProof {
  /** HMAC-SHA-256 in hexadecimal, of the host, the id and the nonce. */
  proof: string;
}

/**
 * Asks a master to prove that it is of the cluster of a client, before the client shows who it is. Rule CU-85.
 *
 * `ubii.extension.MasterProofRequest`
 */
export interface MasterProofRequest {
  /** Id of the client, which is no secret. Its resume token is the key of the proof. */
  targetId: string;
  /** Host and port at which the master is asked, such as 10.0.0.6:8080. */
  host: string;
  /** Random text of the client, another one in each request: 16 to 64 characters of ASCII without spaces. */
  nonce: string;
}

/**
 * How the master is. Counters are totals since its start.
 *
 * `ubii.extension.MasterStatus`
 */
export interface MasterStatus {
  /** UUID of this run of the master, the same as Server.id. */
  masterId: string;
  /** Text for display. */
  name: string;
  /** Semantic versioning. */
  version: string;
  /** Milliseconds since the Unix epoch, master's clock. */
  startedMs: number;
  /** Milliseconds since the Unix epoch, master's clock. */
  nowMs: number;
  /** Records received from clients. */
  recordsIn: number;
  /** Records delivered to subscribers. */
  recordsOut: number;
  /** Bytes of the frames received from clients. */
  bytesIn: number;
  /** Bytes of the frames handed to clients. */
  bytesOut: number;
  /** Records that slow subscribers did not get. */
  dropped: number;
  /** Requests, records and connections refused: malformed, forbidden or over a limit. */
  refused: number;
  /** Topics that hold a value or a subscription. */
  topics: number;
  /**
   * Clients by state.
   * State ACTIVE.
   */
  clientsActive: number;
  /** State INACTIVE. */
  clientsInactive: number;
  /** State UNAVAILABLE. */
  clientsUnavailable: number;
  /** Share of one core used since the sample before, percent. */
  cpuPercent: number;
  /** Resident memory of the process, bytes. */
  memoryBytes: number;
  /** Every StatusSample after since_ms, oldest first, one every 2 s. */
  samples: StatusSample[];
  /** Every StatusEvent after since_ms, oldest first, at most 200. */
  events: StatusEvent[];
  /** What is wrong now, most severe first. */
  problems: StatusProblem[];
  /** Where the master can be reached, best first. */
  addresses: MasterAddress[];
  /**
   * Share of the time in which the master's one thread was busy, in the last measurement, percent. At 100
   * everything waits. Rule EX-45.
   */
  busyPercent: number;
  /** How late the master comes to what is to be done, in the last measurement: 99th percentile, milliseconds. */
  delayMs: number;
  /** Cores of the machine. */
  processors: number;
  /** The cluster that this master belongs to; absent at a master that is alone. Rule CU-72. */
  cluster: ClusterStatus | undefined;
}

/**
 * Asks how the master is. Rules EX-16 to EX-18.
 *
 * `ubii.extension.MasterStatusRequest`
 */
export interface MasterStatusRequest {
  /**
   * Samples and events after this moment are wanted: milliseconds since the Unix epoch, master's
   * clock; 0 asks for all that is kept (10 minutes).
   */
  sinceMs: number;
}

/**
 * An event of a running module. Rule PM-81.
 *
 * `ubii.extension.ModuleEvent`
 */
export interface ModuleEvent {
  /** Id of the session. */
  sessionId: string;
  /** Id of the instance. */
  moduleId: string;
  /** Name of the module. */
  moduleName: string;
  /** Id of the node. */
  nodeId: string;
  /** What happened. */
  kind: ModuleEventKind;
  /** Milliseconds since the Unix epoch, clock of the node. */
  timeMs: number;
  /** Callback it happened in, such as onProcessing; empty when in none. */
  phase: string;
  /** One sentence, or the text of the log line. */
  message: string;
  /** Line in the source of the callback, from 1; 0 when not known. */
  line: number;
  /** Column in that line, from 1; 0 when not known. */
  column: number;
  /** Of a log line: log, info, warn, error or debug. */
  level: string;
  /** Equal events left out since the one before, because there were too many. */
  suppressed: number;
}

/**
 * What existing nodes do not know of a module. Rule EX-22.
 *
 * `ubii.extension.ModuleExtension`
 */
export interface ModuleExtension {
  /** Semantic versioning; empty when the author gave none. */
  version: string;
  /** Names of external libraries it needs of its node, as in state.modules. Rule PM-4. */
  libraries: string[];
  /**
   * True: the master chose the node and may choose another one when it goes away. Set by
   * the master. Rule SE-31.
   */
  replaceable: boolean;
  /** Where the master has it, or the code that a session runs, from. Set by the master. Rule SE-22. */
  origin: ModuleOrigin;
  /** Of stored ones: ids of the invitations whose clients made or changed it. Set by the master. Rule AC-90. */
  grantIds: string[];
  /** Names of the asset sets it needs, as in state.assets. Rule PM-90. */
  assets: string[];
  /** Names of the asset sets it may load while it runs, with state.loadAssets. Rule PM-96. */
  optionalAssets: string[];
}

/**
 * How the modules of a node do, and what they have to say.
 *
 * `ubii.extension.ModuleReports`
 */
export interface ModuleReports {
  /** One entry a module. */
  statistics: ModuleStatistics[];
  /** In the order they happened. */
  events: ModuleEvent[];
}

/**
 * How one running module did since the report before. Rule PM-80.
 *
 * `ubii.extension.ModuleStatistics`
 */
export interface ModuleStatistics {
  /** Id of the instance. */
  moduleId: string;
  /** Name of the module. */
  moduleName: string;
  /** Id of the node it runs on. */
  nodeId: string;
  /** Where it is in its life. */
  status: ProcessingModuleStatus;
  /** Runs since it was created. */
  runs: number;
  /** Runs per second since the report before. */
  runsPerSecond: number;
  /** Median duration of a run since the report before, milliseconds; 0 when there was none. */
  runP50Ms: number;
  /** 95th percentile of it, milliseconds. */
  runP95Ms: number;
  /** Runs that took longer than their mode leaves them, since it was created. */
  overruns: number;
  /** Runs that failed since it was created. */
  errors: number;
  /** How often it was started again after it was killed. */
  restarts: number;
  /** Records put out since it was created. */
  outputs: number;
  /** Outputs that were refused: over a limit, of a wrong format, or without their parameters. */
  outputsRefused: number;
  /** Triggers that wait for the run under way or the minimal delay. */
  waiting: number;
  /** Topics its demuxers have made, and not given back. Rule SE-61. */
  topics: number;
  /** Elements that were refused since it was created because their topic would have been one too many. */
  topicsRefused: number;
  /** Output whose element was refused last for that reason; empty when none was. */
  refusedOutput: string;
  /** Memory of the instance, bytes; 0 when it is not known. Rule SE-64. */
  memoryBytes: number;
  /** Asset set that loads before the module starts; empty when none does. Rule PM-94. */
  loadingSet: string;
  /** Bytes of this set that have arrived. */
  loadedBytes: number;
  /** Bytes of this set. */
  loadingBytes: number;
}

/**
 * One version of a module.
 *
 * `ubii.extension.ModuleVersion`
 */
export interface ModuleVersion {
  /** Grows by one from version to version of one module. */
  number: number;
  /** When it became the module: milliseconds since the Unix epoch, master's clock. */
  timeMs: number;
  /** Where it is from. */
  origin: ModuleVersionOrigin;
  /** What the author calls it, semantic versioning; empty when it has no such name. */
  version: string;
  /** Encoded size of the module, bytes. */
  byteLength: number;
  /** It is what the module is now. None is when the module was deleted. */
  current: boolean;
  /** The module, where it was asked for. */
  module: ProcessingModule | undefined;
}

/**
 * The versions of one module that are kept.
 *
 * `ubii.extension.ModuleVersionList`
 */
export interface ModuleVersionList {
  /** Newest first. */
  elements: ModuleVersion[];
}

/**
 * Asks for the earlier versions of a module. Rules EX-40 to EX-44.
 *
 * `ubii.extension.ModuleVersionRequest`
 */
export interface ModuleVersionRequest {
  /** Name of a stored module; empty for a module of a session. */
  name: string;
  /** Of a module of a session: its id there; empty for a stored module. */
  moduleId: string;
  /** The version whose module is wanted; 0 lists the versions without their modules. */
  number: number;
}

/**
 * What a client says of itself as a node, at registration. Rule PM-60.
 *
 * `ubii.extension.NodeExtension`
 */
export interface NodeExtension {
  /** What kind of program it is. */
  kind: NodeExtensionKind;
  /** True: runs any module that comes with JavaScript code, and takes part in lockstep passes. */
  runsJavascript: boolean;
  /** True: the master may choose it by itself; false: only sessions that name it. */
  acceptsWork: boolean;
  /** Names of the external libraries it offers its modules. */
  libraries: string[];
  /** How many modules it likes to run at once; 0 when it does not say. */
  capacity: number;
  /** Memory that its sandboxed modules may have together, bytes; 0 when it does not say. Rule PM-58. */
  memoryBytes: number;
  /** True: it loads asset sets for trusted modules. Rule PM-91. */
  loadsAssets: boolean;
  /** True: it makes recordings for the master. Rule RC-60. */
  records: boolean;
  /** True: it is a bridge to another system, and answers requests about its mappings. Rule BR-80. */
  isBridge: boolean;
}

/**
 * A node as the master sees it. Rule PM-61.
 *
 * `ubii.extension.NodeInfo`
 */
export interface NodeInfo {
  /** Id of the client, or of the master. */
  clientId: string;
  /** Text for display. */
  name: string;
  /** What it said of itself. */
  node: NodeExtension | undefined;
  /** Names of the modules it has code for. */
  moduleNames: string[];
  /** Modules of sessions it runs now. */
  instances: number;
  /** True when it can be given modules now. */
  available: boolean;
  /** True when it exists to run modules for others. */
  dedicated: boolean;
  /** Memory of the modules of sessions it runs now, bytes, as far as they say. */
  memoryBytes: number;
}

/**
 * Nodes, the master first.
 *
 * `ubii.extension.NodeList`
 */
export interface NodeList {
  /** The master first, then by name. */
  elements: NodeInfo[];
}

/**
 * What the master and a node of this project tell each other over the topic-data channel. Rule EX-20.
 *
 * `ubii.extension.NodeMessage`
 */
export interface NodeMessage {
  /** Master to node: run one lockstep pass. Rule SE-40. */
  lockstepRequest?: LockstepProcessingRequest | undefined;
  /** Node to master: the outputs of that pass. Rule SE-41. */
  lockstepReply?: LockstepProcessingReply | undefined;
  /** Node to master: how its modules do. Rules PM-80 and PM-81. */
  moduleReports?: ModuleReports | undefined;
  /** Node to master: topics that its modules do not write any more. Rule SE-63. */
  endedTopics?: EndedTopics | undefined;
  /** Master to node: something to do for a recording. Rule RC-61. */
  recorderOrder?: NodeRecorderOrder | undefined;
  /** Node to master: what became of an order. Rule RC-61. */
  recorderAnswer?: NodeRecorderAnswer | undefined;
  /** Node to master: the recordings that are there. Rule RC-62. */
  recorderReport?: NodeRecorderReport | undefined;
  /** Master to a node that is a bridge: something that is asked about its mappings. Rule BR-80. */
  bridgeOrder?: BridgeOrder | undefined;
  /** Bridge to master: what it answers. Rule BR-80. */
  bridgeAnswer?: BridgeAnswer | undefined;
}

/**
 * What became of an order. Rule RC-61.
 *
 * `ubii.extension.NodeRecorderAnswer`
 */
export interface NodeRecorderAnswer {
  /** Number of the order. */
  number: number;
  /** The recording that it was about. */
  recording: Recording | undefined;
  /** The marker that it was about. */
  marker: RecordingMarker | undefined;
  /** Why it was refused; absent when it was not. */
  error: ErrorMessage | undefined;
}

/**
 * The clock of a client.
 *
 * `ubii.extension.NodeRecorderClock`
 */
export interface NodeRecorderClock {
  /** Which client. */
  clientId: string;
  /** Its clock. */
  clock: ClientClock | undefined;
}

/**
 * What only the master knows. Rule RC-61.
 *
 * `ubii.extension.NodeRecorderFacts`
 */
export interface NodeRecorderFacts {
  /** Clocks of clients that have changed. */
  clocks: NodeRecorderClock[];
  /** Records that the node did not get, because its connection was too slow. */
  lostCount: number;
  /** Since when, milliseconds since the Unix epoch, master's clock. */
  lostFromMs: number;
  /** Until when, the same clock. */
  lostUntilMs: number;
}

/**
 * A marker for recordings of a node.
 *
 * `ubii.extension.NodeRecorderMark`
 */
export interface NodeRecorderMark {
  /** Of one recording, or of all that run there. */
  marker: RecordingMarker | undefined;
  /** True: markers of others, and of finished recordings, as well. Rule RC-21. */
  mayChangeAll: boolean;
  /** True: it was published to a topic. Rule RC-24. */
  isTopic: boolean;
}

/**
 * Something that a node is to do for a recording that it makes. Rule RC-61.
 *
 * `ubii.extension.NodeRecorderOrder`
 */
export interface NodeRecorderOrder {
  /** Number of the order, which the answer has, too; 0 when no answer is expected. */
  number: number;
  /** Start a recording; the answer has it. */
  start?: NodeRecorderStart | undefined;
  /** Stop it and close its file; the answer has it. */
  stop?: RecordingRequest | undefined;
  /** Describe it with topics and markers. */
  get?: RecordingRequest | undefined;
  /** Change its texts; the answer has it. */
  change?: RecordingChangeRequest | undefined;
  /** Delete it; a running one is stopped. */
  remove?: RecordingRequest | undefined;
  /** Add, change or remove a marker; the answer has it. */
  mark?: NodeRecorderMark | undefined;
  /** Upload its file now; the answer has it once that has begun. */
  upload?: RecordingRequest | undefined;
  /** More that is recorded. */
  sources?: NodeRecorderSources | undefined;
  /** What only the master knows of what is recorded. */
  facts?: NodeRecorderFacts | undefined;
}

/**
 * All recordings of a node that are not at the master. Sent after each connection, when they change, and each second
 * while one runs. Rule RC-62.
 *
 * `ubii.extension.NodeRecorderReport`
 */
export interface NodeRecorderReport {
  /** Without selections, topics and markers. */
  elements: Recording[];
}

/**
 * What one client publishes on one topic.
 *
 * `ubii.extension.NodeRecorderSource`
 */
export interface NodeRecorderSource {
  /** Which topic. */
  topic: string;
  /** Id of the client; empty for the master. */
  clientId: string;
}

/**
 * What clients, devices and sessions of a selection publish, as the master found it. Rule RC-61.
 *
 * `ubii.extension.NodeRecorderSources`
 */
export interface NodeRecorderSources {
  /** Which recording records it. */
  recordingId: string;
  /** Only what is new. */
  elements: NodeRecorderSource[];
}

/**
 * A recording to start.
 *
 * `ubii.extension.NodeRecorderStart`
 */
export interface NodeRecorderStart {
  /** Id, texts, selection, budget, study and replayed recording of it; the rest is empty. */
  recording: Recording | undefined;
  /** Whose it is, as the master writes makers; empty for its operator. Rule RC-66. */
  makerId: string;
  /** Name of the master. */
  masterName: string;
  /** Version of the master. */
  version: string;
  /** Labels of personal data as JSON; empty when there are none. Rule PD-6. */
  personalData: string;
  /** What its clients, devices and sessions publish now. */
  sources: NodeRecorderSources | undefined;
  /** Clocks of clients. */
  facts: NodeRecorderFacts | undefined;
}

/**
 * All labels of a master. Rule PD-3.
 *
 * `ubii.extension.PersonalData`
 */
export interface PersonalData {
  /** In the order in which they are shown. */
  labels: PersonalLabel[];
}

/**
 * Names values in topics that tell something of a person. Rule PD-1.
 *
 * `ubii.extension.PersonalLabel`
 */
export interface PersonalLabel {
  /** Id, which the master assigns when it is empty. */
  id: string;
  /** Topics with the values, as a glob. */
  topicPattern: string;
  /**
   * Members of the value, such as "object2DList.elements.id": the data format, then names of members. Elements of lists
   * have no part of their own. Empty for the whole record.
   */
  fieldPath: string;
  /** What happens to the values. */
  treatment: PersonalTreatment;
  /** Unit of PERSONAL_TREATMENT_ROUND, in the unit of the value. 0 stands for 1. */
  step: number;
  /** Why it is personal, for display. */
  note: string;
}

/**
 * What existing clients do not know of a record. Rule EX-10.
 *
 * `ubii.extension.RecordExtension`
 */
export interface RecordExtension {
  /** How long the value outlives the client that owns the topic, seconds; 0: not at all. Rule TD-43. */
  keepSeconds: number;
  /** How long the value stands while no newer record of the topic comes, milliseconds; 0: as long as any. Rule TD-47. */
  expiryMs: number;
}

/**
 * One recording of a master. Rules RC-1 and RC-2.
 *
 * `ubii.extension.Recording`
 */
export interface Recording {
  /** Assigned by the master. Its file is at /recordings/<id>.mcap. */
  id: string;
  /** Name, for display. */
  name: string;
  /** Where it came from. */
  kind: RecordingKind;
  /** Where it is in its life. */
  state: RecordingState;
  /**
   * Time of its first record, or of its start while it has none: milliseconds since the Unix epoch, clock of
   * the master that recorded it.
   */
  startedMs: number;
  /** From started_ms to its last record, or until now while it is being recorded, milliseconds. */
  durationMs: number;
  /** Size of its file, bytes. */
  sizeBytes: number;
  /** Records of topics in it. */
  recordCount: number;
  /** Records that were selected and are missing in it, because the recorder could not take them in time. */
  lostCount: number;
  /** Topics in it. */
  topicCount: number;
  /** Markers in it. */
  markerCount: number;
  /** What is wrong with it, one or two sentences; empty when nothing is. */
  problem: string;
  /** Notes, for display. */
  notes: string;
  /** Name of the client that started it; empty when none did. */
  author: string;
  /** What it records; empty for everything. */
  selection: RecordingSelection | undefined;
  /** When it stops by itself. */
  budget: RecordingBudget | undefined;
  /** A page of its topics; only in replies of recording_get. Rule RC-54. */
  topics: RecordingTopic[];
  /** A page of its markers, by time; only in replies of recording_get. Rule RC-54. */
  markers: RecordingMarker[];
  /** Of a comparison: id of the recording that was replayed; empty for others. Rule RP-40. */
  replayedRecordingId: string;
  /** Id of the client that records it, or has its file; empty for the master. Rule RC-60. */
  nodeId: string;
  /** Name of that client, for display. */
  nodeName: string;
  /** True: that client is not connected, and the rest is as it was when it was. Rule RC-64. */
  nodeIsAway: boolean;
  /** Bytes of its file that the node has sent to the master; 0 when it is not on its way. Rule RC-63. */
  uploadedBytes: number;
  /** Place of the first of topics among all of them, from 0; only in replies of recording_get. */
  topicsFrom: number;
  /**
   * How many elements all pages of topics have together; only in replies of recording_get. A topic has one for each
   * client that published it.
   */
  topicsTotal: number;
  /**
   * Place of the first of markers among all of them, from 0; only in replies of recording_get. There are
   * marker_count in all.
   */
  markersFrom: number;
  /** Which part of a study it is; absent when it is none. Rule ST-24. */
  study: RecordingStudy | undefined;
}

/**
 * When a recording stops by itself. Rule RC-16.
 *
 * `ubii.extension.RecordingBudget`
 */
export interface RecordingBudget {
  /** Longest duration, milliseconds; 0 for the default of the master. */
  maxDurationMs: number;
  /** Largest size of the file, bytes; 0 for the default of the master. */
  maxBytes: number;
  /** Free space that stays on the disk, bytes; 0 for the default of the master. */
  minFreeBytes: number;
}

/**
 * Changes name and notes of a recording. Rule RC-6.
 *
 * `ubii.extension.RecordingChangeRequest`
 */
export interface RecordingChangeRequest {
  /** Its id. */
  id: string;
  /** The new name; may not be empty. */
  name: string;
  /** The new notes. */
  notes: string;
}

/**
 * What a selection would record now. Rule RC-15.
 *
 * `ubii.extension.RecordingEstimate`
 */
export interface RecordingEstimate {
  /** Each topic that has a value and is selected, those with the most bytes first. */
  topics: RecordingTopicRate[];
  /** Sum of their records per second. */
  recordsPerSecond: number;
  /** Sum of their bytes per second, before compression. */
  bytesPerSecond: number;
  /** Free space on the disk, bytes; 0 when unknown. */
  freeBytes: number;
}

/**
 * All recordings of a master. Rule RC-3.
 *
 * `ubii.extension.RecordingList`
 */
export interface RecordingList {
  /** The newest first. */
  elements: Recording[];
  /** Size of all files, bytes. */
  sizeBytes: number;
  /** Size from which on the master deletes the oldest keepings of the flight recorder, bytes. Rule RC-18. */
  maxBytes: number;
  /** Free space on the disk, bytes; 0 when unknown. */
  freeBytes: number;
}

/**
 * A moment that a user or a module marked. As a request: adds, changes or removes it. Rules RC-20 to RC-23.
 *
 * `ubii.extension.RecordingMarker`
 */
export interface RecordingMarker {
  /** Id of the recording; empty for every running one and the flight recorder. */
  recordingId: string;
  /** Id of the marker; empty for a new one. */
  id: string;
  /** The marked moment: milliseconds since the Unix epoch, master's clock; 0 for now. */
  timeMs: number;
  /** Text, for display; may be empty. */
  text: string;
  /** Name of the client that made it. Set by the master. */
  author: string;
  /** Id of the client that made it; in a request, of the client that asks. */
  clientId: string;
  /** True: removes the marker. */
  isRemoved: boolean;
}

/**
 * Which recording is meant.
 *
 * `ubii.extension.RecordingRequest`
 */
export interface RecordingRequest {
  /** Its id. */
  id: string;
  /** Of recording_get: place of the first topic of the reply among all of them, from 0. Rule RC-54. */
  topicsFrom: number;
  /** Of recording_get: place of the first marker of the reply among all of them, from 0. Rule RC-54. */
  markersFrom: number;
}

/**
 * What a recording records: what any of these members names, or everything when all are empty. Topics,
 * clients, devices and sessions that appear later are recorded as well. Rules RC-10 to RC-13.
 *
 * `ubii.extension.RecordingSelection`
 */
export interface RecordingSelection {
  /** Topics. */
  topics: string[];
  /** Globs of topics: * within a level, ** over levels, ? one character. */
  patterns: string[];
  /** Ids or names of clients: what they publish. */
  clients: string[];
  /** Names or tags of devices, or tags of components: the topics of their components. */
  devices: string[];
  /** Ids or names of sessions: the topics that their graphs read and write. */
  sessions: string[];
  /** Globs of topics that are not recorded, whatever names them. */
  excludedPatterns: string[];
  /** True: records with images are not recorded. */
  withoutImages: boolean;
}

/**
 * Starts a recording. Rule RC-4.
 *
 * `ubii.extension.RecordingStartRequest`
 */
export interface RecordingStartRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Name of the recording; empty for one made of date and time. */
  name: string;
  /** Notes, for display. */
  notes: string;
  /** What to record; absent for everything. */
  selection: RecordingSelection | undefined;
  /** When to stop; absent for the defaults. */
  budget: RecordingBudget | undefined;
  /** Id of the node that is to record; empty for the master. Rule RC-60. */
  nodeId: string;
}

/**
 * What is recorded now, published on /ubii/recordings about once a second while something changes. Rule RC-8.
 *
 * `ubii.extension.RecordingStatus`
 */
export interface RecordingStatus {
  /** Recordings that run, the newest first, without notes and selections. */
  running: Recording[];
  /** The flight recorder, without its slots. */
  flightRecorder: FlightRecorder | undefined;
  /** Grows when the list of recordings changes: one is added, changed, finished or deleted. */
  listRevision: number;
}

/**
 * Which part of a study a recording is.
 *
 * `ubii.extension.RecordingStudy`
 */
export interface RecordingStudy {
  /** Id of the study. */
  studyId: string;
  /** Its name. */
  studyName: string;
  /** Id of the run. */
  runId: string;
  /** Pseudonym of the participant. */
  participantCode: string;
  /** Which visit of the participant. */
  visit: string;
  /** Name of the condition. */
  condition: string;
  /** Number of the block in the run, from 1. */
  block: number;
  /** {run} of the name of the recording, from 1. */
  runNumber: number;
}

/**
 * One topic of a recording, as one client published it.
 *
 * `ubii.extension.RecordingTopic`
 */
export interface RecordingTopic {
  /** Which topic. */
  topic: string;
  /** Id of the client that published; empty for the master itself. */
  clientId: string;
  /** Its name. */
  clientName: string;
  /** Short name of the data format of its first record. */
  dataFormat: string;
  /** Records in the file. */
  recordCount: number;
}

/**
 * What one topic takes.
 *
 * `ubii.extension.RecordingTopicRate`
 */
export interface RecordingTopicRate {
  /** Which topic. */
  topic: string;
  /** Short name of the data format of its newest record. */
  dataFormat: string;
  /** Records per second. */
  recordsPerSecond: number;
  /** Bytes per second, before compression. */
  bytesPerSecond: number;
}

/**
 * A recording that is played into live topics. Rule RP-1.
 *
 * `ubii.extension.Replay`
 */
export interface Replay {
  /** Assigned by the master. */
  id: string;
  /** Name of its client. */
  name: string;
  /** Which recording is played. */
  recordingId: string;
  /** Its name; of a recording of a study, without the participant. Rule ST-54. */
  recordingName: string;
  /** Name of the client that started it; empty when none did. */
  author: string;
  /** Where it is in its life. */
  state: ReplayState;
  /** Playhead, milliseconds since the start of the recording. */
  positionMs: number;
  /** Duration of the recording, milliseconds. */
  durationMs: number;
  /** Speed. */
  rate: number;
  /** What is played; until_ms is set. */
  span: ReplaySpan | undefined;
  /** Whether it begins again at the end of the span. */
  isLooping: boolean;
  /** Whether it is a ghost. */
  isGhost: boolean;
  /** Copies of a ghost; else 1. */
  copies: number;
  /** Ids of its clients, one for each copy. */
  clientIds: string[];
  /** What happens to live records of its topics. */
  conflict: ReplayConflict;
  /** Prefix for moved records; empty unless they are moved. */
  livePrefix: string;
  /** Topics that it has published. */
  topicCount: number;
  /** Records that it has published. */
  recordCount: number;
  /** Live records that were dropped or moved because of it. */
  mutedCount: number;
  /** Topics of these, the first 100. */
  mutedTopics: string[];
  /** Records that the master refused, such as on topics of its own. */
  refusedCount: number;
  /** What is wrong with it, one or two sentences; empty when nothing is. */
  problem: string;
  /** The session that runs again; absent when none does. */
  session: ReplayedSession | undefined;
  /** Time at which it started: milliseconds since the Unix epoch, master's clock. */
  startedMs: number;
  /** Start of the recording, as started_ms of the recording. */
  recordingStartedMs: number;
}

/**
 * Changes a replay. What is absent or 0 stays as it is. Carried out in the order of the members. Rule RP-5.
 *
 * `ubii.extension.ReplayChangeRequest`
 */
export interface ReplayChangeRequest {
  /** Id of the replay. */
  id: string;
  /** Speed, 0.1 to 10. */
  rate: number;
  /** Span and loop. */
  loop: ReplayLoop | undefined;
  /** Jumps to a moment, and publishes the last value of every topic there. */
  seek: ReplaySeek | undefined;
  /** Pauses, and goes on by so many records, or with a negative number back. */
  step: number;
  /** Plays or pauses. */
  action: ReplayAction;
}

/**
 * All replays of a master, published on /ubii/replays when one changes, and up to five times a second while one
 * plays. Rule RP-7.
 *
 * `ubii.extension.ReplayList`
 */
export interface ReplayList {
  /** In the order in which they started. */
  elements: Replay[];
}

/**
 * The span and loop that a replay should have.
 *
 * `ubii.extension.ReplayLoop`
 */
export interface ReplayLoop {
  /** What is played; absent for the whole recording. */
  span: ReplaySpan | undefined;
  /** True: begins again at the end of the span. */
  isLooping: boolean;
}

/**
 * Other topics for those that begin with a prefix. The longest prefix of all counts. Rule RP-13.
 *
 * `ubii.extension.ReplayRename`
 */
export interface ReplayRename {
  /** Beginning of recorded topics. */
  fromPrefix: string;
  /** Beginning that they get instead. */
  toPrefix: string;
}

/**
 * Which replay is meant.
 *
 * `ubii.extension.ReplayRequest`
 */
export interface ReplayRequest {
  /** Its id. */
  id: string;
}

/**
 * A moment of a replay to jump to.
 *
 * `ubii.extension.ReplaySeek`
 */
export interface ReplaySeek {
  /** Milliseconds since the start of the recording. */
  positionMs: number;
}

/**
 * A span of a recording, milliseconds since the start of the recording.
 *
 * `ubii.extension.ReplaySpan`
 */
export interface ReplaySpan {
  /** Its first moment. */
  fromMs: number;
  /** Its last moment; 0 for the end of the recording. */
  untilMs: number;
}

/**
 * Starts a replay of a finished recording. Rule RP-1.
 *
 * `ubii.extension.ReplayStartRequest`
 */
export interface ReplayStartRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Which recording. */
  recordingId: string;
  /** Globs of recorded topics: * within a level, ** over levels, ? one character. Empty for all. */
  topics: string[];
  /** Globs of recorded topics that are left out. */
  excludedTopics: string[];
  /** Other names for topics. */
  renames: ReplayRename[];
  /** What happens to live records of the same topics. A ghost keeps them, whatever is set. */
  conflict: ReplayConflict;
  /** Prefix for MOVE_LIVE; empty for /live. */
  livePrefix: string;
  /** Speed, 0.1 to 10; 0 for 1. */
  rate: number;
  /** True: begins paused. */
  isPaused: boolean;
  /** What is played; absent for the whole recording. */
  span: ReplaySpan | undefined;
  /** True: begins again at the end of the span. */
  isLooping: boolean;
  /** True: records keep their recorded timestamps. False: these become the time at which they are published. */
  keepsTimestamps: boolean;
  /** Copies of a ghost, 1 to 32; 0 for 1. */
  copies: number;
  /** The starts of the copies of a ghost are spread over so many milliseconds. */
  jitterMs: number;
  /** True: a ghost, which plays its span in a loop as clients of its own. Rule RP-30. */
  isGhost: boolean;
  /** Name of its client; empty for one made of the name of the recording. */
  name: string;
  /** Id of a recorded session that runs again on the replayed inputs; empty for none. Rule RP-40. */
  sessionId: string;
}

/**
 * A recorded session that runs again with the modules of today. Rule RP-40.
 *
 * `ubii.extension.ReplayedSession`
 */
export interface ReplayedSession {
  /** Its id in the recording. */
  sessionId: string;
  /** Its name. */
  name: string;
  /** Id of the temporary session. */
  runningId: string;
  /** Id of the recording of its outputs. */
  comparisonRecordingId: string;
  /** Inputs are at this prefix and the recorded topic. */
  inputPrefix: string;
  /** Outputs are at this prefix and the recorded topic. */
  outputPrefix: string;
  /** Names of its modules that are not in the library of today: these run with their recorded code. */
  recordedModules: string[];
}

/**
 * What existing clients do not know of a session. Rule EX-22.
 *
 * `ubii.extension.SessionExtension`
 */
export interface SessionExtension {
  /** Where it is in its life. Set by the master. Rule SE-10. */
  state: SessionState;
  /** What is wrong with it now, errors first. Set by the master. Rule SE-3. */
  problems: SessionProblem[];
  /** True: the master starts it again after a restart, if it ran before. Rule SE-24. */
  startWithMaster: boolean;
  /** Lockstep passes per second at most; 0 means 60. Rule SE-40. */
  lockstepHertz: number;
  /** What graph editors keep: positions, comments, frames; JSON text that the master does not read. */
  editorJson: string;
  /**
   * Grows with every change of the specification. In an update, when not 0: the revision it was made from.
   * Rule SE-15.
   */
  revision: number;
  /** True when it is also stored. Rule SE-21. */
  stored: boolean;
  /** Ids of the invitations whose clients made or changed it. Set by the master. Rule AC-90. */
  grantIds: string[];
  /**
   * Id of the master of the cluster that runs it, or ran it when that master is lost; empty at a master that is alone.
   * Set by the master. Rule CU-71.
   */
  masterId: string;
  /** Name of the lost master from which that master took it over; empty for sessions that did not move. Set by the master. */
  movedFrom: string;
  /** When it was taken over: milliseconds since the Unix epoch, clock of the master that runs it. Set by the master. */
  movedMs: number;
}

/**
 * Something wrong with a session, and where. Rules SE-3 and SE-12.
 *
 * `ubii.extension.SessionProblem`
 */
export interface SessionProblem {
  /** True: it cannot run like this; false: a warning. */
  isError: boolean;
  /** Stable reason from a closed list. */
  code: string;
  /** One sentence: what is wrong and what to do. */
  message: string;
  /** Where in the session, such as ioMappings[0].inputMappings[1].topic; empty when nowhere special. */
  path: string;
  /** Id of the module it is about, if any. */
  moduleId: string;
  /** Name of the module it is about, if any. */
  moduleName: string;
  /** Id of the node it is about, if any. */
  nodeId: string;
  /** Line in the source of the callback, from 1; 0 when not known. */
  line: number;
  /** Column in that line, from 1; 0 when not known. */
  column: number;
}

/**
 * How a running session does. Rule SE-50.
 *
 * `ubii.extension.SessionStatistics`
 */
export interface SessionStatistics {
  /** Id of the session. */
  sessionId: string;
  /** Where it is in its life. */
  state: SessionState;
  /** Milliseconds since the Unix epoch, master's clock. */
  timeMs: number;
  /** Its modules. */
  modules: ModuleStatistics[];
  /** Lockstep passes per second since the report before. */
  passesPerSecond: number;
  /** Median duration of a pass since the report before, milliseconds. */
  passP50Ms: number;
  /** 95th percentile of it, milliseconds. */
  passP95Ms: number;
  /** Answers of nodes that came too late for their pass, since the session started. */
  lateAnswers: number;
  /** Memory that its modules may have together on the master, bytes. Rule SE-64. */
  memoryLimitBytes: number;
}

/**
 * One option of a master.
 *
 * `ubii.extension.Setting`
 */
export interface Setting {
  /** Its flag, such as --data-dir. */
  flag: string;
  /** The value in force as it is written in the configuration; paths below the home folder begin with ~. */
  value: string;
  /** What it does. */
  description: string;
  /** True when it was configured, false when it is the default. */
  given: boolean;
}

/**
 * What a master was started with. Rule EX-50.
 *
 * `ubii.extension.SettingList`
 */
export interface SettingList {
  /** Each option once, in the order of its help. */
  elements: Setting[];
  /** What the master runs on, such as Node.js v20.19.0, linux x64. */
  runtime: string;
}

/**
 * An event for the status page.
 *
 * `ubii.extension.StatusEvent`
 */
export interface StatusEvent {
  /** When: milliseconds since the Unix epoch, master's clock. */
  timeMs: number;
  /** What happened. */
  kind: StatusEventKind;
  /** Short text for display. */
  text: string;
  /** The client it is about; empty when it is about none. */
  clientId: string;
}

/**
 * Something that is wrong now.
 *
 * `ubii.extension.StatusProblem`
 */
export interface StatusProblem {
  /**
   * Stable name of the kind of problem: client_silent, client_slow, limit_reached, protocol_errors,
   * file_broken, session_degraded, client_throttled, publisher_noisy, module_slow, master_busy,
   * machine_busy, cluster_unreachable.
   */
  code: string;
  /** How bad it is. */
  severity: StatusProblemSeverity;
  /** What is wrong and what follows from it, one sentence. */
  text: string;
  /** The client it is about; empty when it is about none. */
  clientId: string;
  /** Since when: milliseconds since the Unix epoch, master's clock. */
  sinceMs: number;
  /** What to do about it, one sentence; empty when there is no remedy. */
  remedy: string;
  /** The session it is about; empty when it is about none. */
  sessionId: string;
  /** The module of that session it is about; empty when it is about none. */
  moduleId: string;
}

/**
 * How busy the master was at one moment.
 *
 * `ubii.extension.StatusSample`
 */
export interface StatusSample {
  /** Milliseconds since the Unix epoch, master's clock. */
  timeMs: number;
  /** Records received per second. */
  recordsPerSecond: number;
  /** Share of one core used, percent; more than 100 when several are. */
  cpuPercent: number;
  /** Share of the time in which the master's one thread was busy, percent. */
  busyPercent: number;
  /** How late the master came to what was to be done: 99th percentile, milliseconds. */
  delayMs: number;
  /** Records handed to subscribers per second. */
  recordsOutPerSecond: number;
}

/**
 * A study: what each participant does, and what is recorded of it. As a request: creates or replaces it. Rules ST-1 to ST-4.
 *
 * `ubii.extension.Study`
 */
export interface Study {
  /** Assigned by the master; empty in a request that creates it. */
  id: string;
  /** Name, for display; its letters and digits are {study} in names of recordings. */
  name: string;
  /** Notes for those who run the study. */
  notes: string;
  /** What participants consent to; when it is empty, blocks begin without consent. Rule ST-22. */
  consentText: string;
  /** What has to be there before a block begins. Rule ST-30. */
  devices: StudyDevice[];
  /** Conditions, at least one. */
  conditions: StudyCondition[];
  /** How they are ordered. */
  order: StudyOrder;
  /** Times that each condition is done, from 1. */
  repetitions: number;
  /** Duration after which a block ends by itself, milliseconds; 0 for none. */
  blockMs: number;
  /** What a block records; absent for everything. */
  selection: RecordingSelection | undefined;
  /** Template of names of recordings, such as sub-{participant}_ses-{session}_task-{condition}_run-{run}; empty for that. Rule ST-12. */
  nameTemplate: string;
  /** Grows with each change. In a request: the revision that was changed; 0 to create. Rule ST-3. */
  revision: number;
  /** Version of the consent text: grows with each change; 0 when there was never one. Set by the master. */
  consentVersion: number;
  /** Texts that participants consented to and that were changed since. Set by the master; only in replies of study_get. */
  earlierConsentTexts: StudyConsentText[];
  /** Participants. Set by the master. */
  participantCount: number;
  /** Runs. Set by the master. */
  runCount: number;
  /** Last change: milliseconds since the Unix epoch. Set by the master. */
  changedMs: number;
  /**
   * Globs of topics with settings, which tell nothing of people: recordings begin with their last values, also with those that were
   * published before the run. Rule ST-26.
   */
  settingPatterns: string[];
}

/**
 * One condition of a run, done once.
 *
 * `ubii.extension.StudyBlock`
 */
export interface StudyBlock {
  /** Name of the condition. */
  condition: string;
  /** Which repetition of the condition, from 1. */
  repetition: number;
  /** Id of the session that runs with it; empty for none. */
  sessionId: string;
  /** Where it is in its life. */
  state: StudyBlockState;
  /** Its recordings, the oldest first; more than one when it was repeated. */
  takes: StudyTake[];
}

/**
 * One requirement of a device, as it is now.
 *
 * `ubii.extension.StudyCheckItem`
 */
export interface StudyCheckItem {
  /** What is checked. */
  kind: StudyCheckKind;
  /** Whether it is fulfilled. */
  state: StudyCheckState;
  /** A few words with values, such as "12 of 30 Hz". */
  text: string;
}

/**
 * The required devices of a study, as they are now. Rule ST-30.
 *
 * `ubii.extension.StudyCheckList`
 */
export interface StudyCheckList {
  /** Id of the study. */
  studyId: string;
  /** When: milliseconds since the Unix epoch. */
  timeMs: number;
  /** In the order of the study. */
  rows: StudyCheckRow[];
  /** True: no row is missing or low. */
  isReady: boolean;
}

/**
 * One required device, as it is now.
 *
 * `ubii.extension.StudyCheckRow`
 */
export interface StudyCheckRow {
  /** Name of the required device. */
  name: string;
  /** The worst of its items. */
  state: StudyCheckState;
  /** Presence, and each requirement that the study has. */
  items: StudyCheckItem[];
  /** Names of the devices and clients that were found; at most 20. */
  found: string[];
}

/**
 * One condition of a study.
 *
 * `ubii.extension.StudyCondition`
 */
export interface StudyCondition {
  /** Name, for display; its letters and digits are {condition} in names of recordings. */
  name: string;
  /** Id of a stored session that runs during its blocks; empty for none. */
  sessionId: string;
}

/**
 * Consent of a participant. Rule ST-22.
 *
 * `ubii.extension.StudyConsent`
 */
export interface StudyConsent {
  /** Version of the text. */
  version: number;
  /** When: milliseconds since the Unix epoch. */
  timeMs: number;
  /** Name of the client that confirmed it; empty when none did. */
  author: string;
}

/**
 * A consent text as it was.
 *
 * `ubii.extension.StudyConsentText`
 */
export interface StudyConsentText {
  /** Its version. */
  version: number;
  /** The text. */
  text: string;
}

/**
 * What was deleted of a participant. Rule ST-51.
 *
 * `ubii.extension.StudyDeletion`
 */
export interface StudyDeletion {
  /** Names of the deleted recordings. */
  recordingNames: string[];
  /** Size of them, bytes. */
  sizeBytes: number;
  /** Deleted runs. */
  runCount: number;
  /** Deleted notes. */
  noteCount: number;
  /** Names of the studies that had the participant. */
  studyNames: string[];
  /** Recordings that were made during the runs of the participant and stay, the newest first; at most 100. Rule ST-53. */
  otherRecordings: StudyOtherRecording[];
}

/**
 * What a study needs. One of topic_pattern, data_format and tag is set. Rule ST-30.
 *
 * `ubii.extension.StudyDevice`
 */
export interface StudyDevice {
  /** Name, for display. */
  name: string;
  /** Glob of topics that it publishes. */
  topicPattern: string;
  /** Short name of the data format that it publishes. */
  dataFormat: string;
  /** Tag of a device or of a component. */
  tag: string;
  /** How many are needed; 0 for one. */
  count: number;
  /** Records per second at least; 0 for any. */
  minRateHz: number;
  /** Charge at least, 0 to 1; 0 for any. */
  minBattery: number;
  /** Clock error at most, milliseconds; 0 for any. */
  maxClockErrorMs: number;
}

/**
 * All studies, in the order of their names, without notes and texts.
 *
 * `ubii.extension.StudyList`
 */
export interface StudyList {
  /** The studies. */
  elements: Study[];
}

/**
 * A note on a run.
 *
 * `ubii.extension.StudyNote`
 */
export interface StudyNote {
  /** When: milliseconds since the Unix epoch. */
  timeMs: number;
  /** Text. */
  text: string;
  /** Name of the client that wrote it; empty when none did. */
  author: string;
  /** Number of the block that ran, from 1; 0 when none did. */
  block: number;
}

/**
 * A recording that may have data of a participant.
 *
 * `ubii.extension.StudyOtherRecording`
 */
export interface StudyOtherRecording {
  /** Its id. */
  id: string;
  /** Its name. */
  name: string;
}

/**
 * One participant of a study. Rule ST-50.
 *
 * `ubii.extension.StudyParticipant`
 */
export interface StudyParticipant {
  /** Id of the study. */
  studyId: string;
  /** Pseudonym. */
  code: string;
  /** Number in the study, from 1. */
  number: number;
  /** Ids of the runs, the newest first. */
  runIds: string[];
  /** Ids of the recordings that are there, the newest first. */
  recordingIds: string[];
  /** Size of them, bytes. */
  sizeBytes: number;
  /** Start of the last run: milliseconds since the Unix epoch. */
  lastMs: number;
}

/**
 * Participants, by study and code.
 *
 * `ubii.extension.StudyParticipantList`
 */
export interface StudyParticipantList {
  /** The participants. */
  elements: StudyParticipant[];
}

/**
 * Which participants are meant. Rules ST-50 and ST-51.
 *
 * `ubii.extension.StudyParticipantRequest`
 */
export interface StudyParticipantRequest {
  /** Id of the study; empty for all studies. */
  studyId: string;
  /** Pseudonym of the participant. To list: empty for all. */
  participantCode: string;
}

/**
 * Which study is meant.
 *
 * `ubii.extension.StudyRequest`
 */
export interface StudyRequest {
  /** Its id. */
  id: string;
}

/**
 * One participant doing a study once. Rule ST-20.
 *
 * `ubii.extension.StudyRun`
 */
export interface StudyRun {
  /** Assigned by the master. */
  id: string;
  /** Id of the study. */
  studyId: string;
  /** Pseudonym of the participant, letters and digits, such as P01. */
  participantCode: string;
  /** Number of the participant in the study, from 1: the row of the balanced order. */
  participantNumber: number;
  /** Which visit of the participant, letters and digits, such as 1; {session} in names of recordings. */
  visit: string;
  /** Where it is in its life. */
  state: StudyRunState;
  /** Grows with each change. */
  revision: number;
  /** Its start: milliseconds since the Unix epoch. */
  startedMs: number;
  /** Its end, the same clock; 0 while it is not ended. */
  endedMs: number;
  /** Consent; absent before it is given. */
  consent: StudyConsent | undefined;
  /** Blocks, in the order in which they are done. */
  blocks: StudyBlock[];
  /** Notes, the oldest first. */
  notes: StudyNote[];
}

/**
 * Does something with a run. Rules ST-21 to ST-25.
 *
 * `ubii.extension.StudyRunChangeRequest`
 */
export interface StudyRunChangeRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Id of the run. */
  runId: string;
  /** What to do. */
  action: StudyRunAction;
  /** Number of the block, from 1; 0 for the next one that is pending. */
  block: number;
  /** To begin a block: also when required devices are missing. Rule ST-31. */
  isForced: boolean;
  /** Text of the note. */
  text: string;
  /** To consent: version of the text that the participant read. */
  consentVersion: number;
}

/**
 * Runs, the newest first.
 *
 * `ubii.extension.StudyRunList`
 */
export interface StudyRunList {
  /** The runs. */
  elements: StudyRun[];
}

/**
 * Which runs are listed.
 *
 * `ubii.extension.StudyRunListRequest`
 */
export interface StudyRunListRequest {
  /** Id of the study; empty for all. */
  studyId: string;
  /** Pseudonym of the participant; empty for all. */
  participantCode: string;
}

/**
 * A run that is open, in short. Participants are not named in it.
 *
 * `ubii.extension.StudyRunNews`
 */
export interface StudyRunNews {
  /** Id of the run. */
  runId: string;
  /** Id of the study. */
  studyId: string;
  /** Revision of the run. */
  revision: number;
  /** Number of the block that runs, from 1; 0 for none. */
  block: number;
  /** Id of its recording. */
  recordingId: string;
  /** Time since the block began, milliseconds. */
  elapsedMs: number;
  /** Duration after which the block ends by itself, milliseconds; 0 for none. */
  blockMs: number;
}

/**
 * Which run is meant.
 *
 * `ubii.extension.StudyRunRequest`
 */
export interface StudyRunRequest {
  /** Its id. */
  id: string;
}

/**
 * Starts a run. Rule ST-20.
 *
 * `ubii.extension.StudyRunStartRequest`
 */
export interface StudyRunStartRequest {
  /** Id of the client that asks; empty when none does. */
  clientId: string;
  /** Id of the study. */
  studyId: string;
  /** Pseudonym of the participant, letters and digits. */
  participantCode: string;
  /** Which visit, letters and digits; empty for 1. */
  visit: string;
}

/**
 * Open runs and check lists, published on /ubii/studies when something changes, and each second while a run is open or a check
 * list is wanted. Rule ST-40.
 *
 * `ubii.extension.StudyStatus`
 */
export interface StudyStatus {
  /** Open runs. */
  runs: StudyRunNews[];
  /** Check lists of studies with open runs, and of those that are wanted. */
  checkLists: StudyCheckList[];
  /** Grows when studies, runs or participants change. */
  listRevision: number;
}

/**
 * One recording of a block.
 *
 * `ubii.extension.StudyTake`
 */
export interface StudyTake {
  /** Id of the recording. */
  recordingId: string;
  /** Its name when it was made. */
  name: string;
  /** {run} of its name. */
  runNumber: number;
  /** Its start: milliseconds since the Unix epoch. */
  startedMs: number;
  /** Its end, the same clock; 0 while it runs, and when the master exited before. */
  endedMs: number;
  /** What was wrong with required devices when it began anyway; empty when nothing was. Rule ST-31. */
  forced: string;
  /** What is wrong with it; empty when nothing is. */
  problem: string;
}

/**
 * A module of a session with an input that gets the topic.
 *
 * `ubii.extension.SubscribedModule`
 */
export interface SubscribedModule {
  /** Name of the module. */
  name: string;
  /** Id of its session. */
  sessionId: string;
  /** Name of its session. */
  sessionName: string;
  /** Id of the client, or of the master, that runs it. */
  nodeId: string;
}

/**
 * The mark of a client that is here.
 *
 * `ubii.extension.TakenMark`
 */
export interface TakenMark {
  /** Name of the client. */
  name: string;
  /** Its mark. */
  mark: Mark | undefined;
}

/**
 * Counters of one topic. All counts are totals since the topic appeared; a rate is the difference of
 * two replies over the difference of their master_time_ms.
 *
 * `ubii.extension.TopicStatistic`
 */
export interface TopicStatistic {
  /** Which topic. */
  topic: string;
  /** Short name of the data format of the newest record (vector2, image2D, ...); empty while the topic has no value. */
  dataFormat: string;
  /** Id of the client that published the newest record; empty for the master itself. */
  publisherId: string;
  /** Records published. */
  records: number;
  /** Encoded size of those records, bytes. */
  bytes: number;
  /** Records that a slow subscriber did not get because a newer one replaced them, summed over subscribers. */
  dropped: number;
  /** When the newest record arrived: milliseconds since the Unix epoch, master's clock; 0 when none did. */
  publishedMs: number;
  /** Clients that receive this topic now. */
  subscribers: number;
  /** Encoded size of the newest record, bytes. */
  valueBytes: number;
}

/**
 * Statistics of the topics that changed since the cursor of the request.
 *
 * `ubii.extension.TopicStatistics`
 */
export interface TopicStatistics {
  /** To be sent with the next request. */
  cursor: number;
  /** True when this is a full list: everything the client knew from earlier replies is void. */
  reset: boolean;
  /** Topics in no promised order; all of them after a reset, else those that changed. */
  elements: TopicStatistic[];
  /** Topics that were deleted since the cursor. */
  removed: string[];
  /** When this was taken: milliseconds since the Unix epoch, master's clock. */
  masterTimeMs: number;
}

/**
 * Asks for the statistics of the topics that changed since an earlier reply. Rules EX-11 to EX-15.
 *
 * `ubii.extension.TopicStatisticsRequest`
 */
export interface TopicStatisticsRequest {
  /** Cursor of the reply the client already has; 0 asks for every topic. */
  cursor: number;
}

/**
 * Who receives the records of one topic.
 *
 * `ubii.extension.TopicSubscribers`
 */
export interface TopicSubscribers {
  /** Which topic. */
  topic: string;
  /** Clients that receive it, with the caller if it does; the master counts as one when its own modules do. */
  count: number;
  /** Their ids, that of the master for its own modules; empty when the caller may not list clients. */
  clientIds: string[];
  /** Modules of sessions that receive it; empty when the caller may not list sessions. */
  modules: SubscribedModule[];
}

/**
 * Who receives the records of topics, in the order of the request.
 *
 * `ubii.extension.TopicSubscribersList`
 */
export interface TopicSubscribersList {
  /** One for each topic that was asked for. */
  elements: TopicSubscribers[];
}

/**
 * Asks who receives the records of topics. Rules EX-95 to EX-97.
 *
 * `ubii.extension.TopicSubscribersRequest`
 */
export interface TopicSubscribersRequest {
  /** The topics, at most 16. */
  topics: string[];
}

/**
 * Something was refused or went wrong.
 *
 * `ubii.general.Error`
 */
export interface ErrorMessage {
  /** Short text for display. */
  title: string;
  /** One sentence: what was wrong and what to do. */
  message: string;
  /** Where in the code it happened; a master of this project leaves it empty. */
  stack: string;
  /** Stable reason from the closed list of error codes. Rule EX-9. */
  code: string;
  /** Of a session that was refused: all that is wrong with it. Rules SE-3 and EX-24. */
  problems: SessionProblem[];
  /** Why a caller cannot join, when that is what the error is about. Rule AC-12. */
  join: JoinRefusal | undefined;
}

/**
 * Errors.
 *
 * `ubii.general.ErrorList`
 */
export interface ErrorList {
  /** In the order they happened. */
  elements: ErrorMessage[];
}

/**
 * Something was done that returns nothing else.
 *
 * `ubii.general.Success`
 */
export interface Success {
  /** Short text for display. */
  title: string;
  /** One sentence on what was done. */
  message: string;
}

/**
 * Successes.
 *
 * `ubii.general.SuccessList`
 */
export interface SuccessList {
  /** In the order they happened. */
  elements: Success[];
}

/**
 * What the modules put out in one pass. Published when all nodes have answered.
 *
 * `ubii.processing.LockstepProcessingReply`
 */
export interface LockstepProcessingReply {
  /** Modules that ran. */
  processingModuleIds: string[];
  /** Outputs of all of them, identified by topic. */
  records: TopicDataRecord[];
  /** Number of the pass this answers. Rule SE-41. */
  pass: number;
  /** Id of the session. */
  sessionId: string;
}

/**
 * Asks a node to run modules once, all on inputs taken at the same moment.
 *
 * `ubii.processing.LockstepProcessingRequest`
 */
export interface LockstepProcessingRequest {
  /** Modules to run. */
  processingModuleIds: string[];
  /** Inputs of all of them, identified by topic. */
  records: TopicDataRecord[];
  /** Since the pass before, milliseconds. */
  deltaTimeMs: number;
  /** Number of the pass in this session. Rule SE-40. */
  pass: number;
  /** Id of the session. */
  sessionId: string;
  /** Since the pass before, milliseconds, with fractions. */
  deltaTime: number;
}

/**
 * An input or output of a module.
 *
 * `ubii.processing.ModuleIO`
 */
export interface ModuleIO {
  /** What the code calls it; unique among the inputs or the outputs. */
  internalName: string;
  /** Data format, by full or short name. */
  messageFormat: string;
  /** True when it is a list of records, as multiplexers yield and demultiplexers take. */
  isRecordList: boolean;
  /** Of an input: its value while it has no record, as JSON such as {"double":1}; empty where there is none. Rule PM-5. */
  defaultJson: string;
  /** For people: what the values mean, with unit and range, one sentence. Rule PM-6. */
  description: string;
  /** Of an input for a string: the texts it understands; empty: any. Rule PM-7. */
  choices: string[];
}

/**
 * When a module runs. Nothing set means a frequency of 30 Hz.
 *
 * `ubii.processing.ProcessingMode`
 */
export interface ProcessingMode {
  /** Fixed intervals. */
  frequency?: ProcessingModeFrequency | undefined;
  /** Passes together. */
  lockstep?: ProcessingModeLockstep | undefined;
  /** Changed inputs. */
  triggerOnInput?: ProcessingModeTriggerOnInput | undefined;
  /** Its own timing. */
  free?: ProcessingModeFree | undefined;
}

/**
 * As the module pleases.
 *
 * `ubii.processing.ProcessingMode.Free`
 */
export interface ProcessingModeFree {
}

/**
 * At fixed intervals, with or without new inputs.
 *
 * `ubii.processing.ProcessingMode.Frequency`
 */
export interface ProcessingModeFrequency {
  /** Runs per second. */
  hertz: number;
}

/**
 * In passes with all lockstep modules of the session, on one snapshot of the inputs.
 *
 * `ubii.processing.ProcessingMode.Lockstep`
 */
export interface ProcessingModeLockstep {
  /** Where the node takes the request for a pass. */
  processRequestEndpoint: string;
}

/**
 * When inputs have changed.
 *
 * `ubii.processing.ProcessingMode.TriggerOnInput`
 */
export interface ProcessingModeTriggerOnInput {
  /** Shortest time from one run to the next, milliseconds. */
  minDelayMs: number;
  /** True: every input must have changed since the run before; false: any. */
  allInputsNeedUpdate: boolean;
}

/**
 * A small computation with inputs, outputs, state and callbacks: what it is, where it runs, how it is.
 *
 * `ubii.processing.ProcessingModule`
 */
export interface ProcessingModule {
  /** UUID of this instance. */
  id: string;
  /** Which module it is; nodes find the code they have by it. */
  name: string;
  /** Who wrote it. */
  authors: string[];
  /** Words to find it by. */
  tags: string[];
  /** Text for display. */
  description: string;
  /** Id of the client, or of the master, that runs it. */
  nodeId: string;
  /** Id of the session it belongs to. */
  sessionId: string;
  /** Where it is in its life. */
  status: ProcessingModuleStatus;
  /** When it runs; absent means 30 Hz. */
  processingMode: ProcessingMode | undefined;
  /** What it takes. */
  inputs: ModuleIO[];
  /** What it puts out. */
  outputs: ModuleIO[];
  /** What the callbacks are written in; left out when not known. */
  language: ProcessingModuleLanguage;
  /** Source of the function that is called for each run: (deltaTime in ms, inputs, state). */
  onProcessingStringified: string;
  /** Source of the function that is called once before the first run: (state). */
  onCreatedStringified: string;
  /** Source of the function that is called when it is stopped: (state). */
  onHaltedStringified: string;
  /** Source of the function that is called before it is gone: (state). */
  onDestroyedStringified: string;
  /** What existing nodes do not know of it. Rule EX-22. */
  extension: ModuleExtension | undefined;
}

/**
 * Processing modules.
 *
 * `ubii.processing.ProcessingModuleList`
 */
export interface ProcessingModuleList {
  /** In no promised order. */
  elements: ProcessingModule[];
}

/**
 * A master: its name and addresses.
 *
 * `ubii.servers.Server`
 */
export interface Server {
  /** UUID, new at every start; the node id of modules the master runs itself. */
  id: string;
  /** Text for display. */
  name: string;
  /** IPv4 address in the wired network; empty when there is none or the master listens on loopback only. */
  ipEthernet: string;
  /** IPv4 address in the wireless network; empty like ip_ethernet. */
  ipWlan: string;
  /** Port of the services over ZeroMQ, decimal. */
  portServiceZmq: string;
  /** Port of the services over HTTP, decimal. */
  portServiceRest: string;
  /** Port of the topic data over ZeroMQ, decimal. */
  portTopicDataZmq: string;
  /** Port of the topic data over WebSocket, decimal. */
  portTopicDataWs: string;
  /** Topics and message names by the keys existing clients know, as JSON text. */
  constantsJson: string;
  /** Host and port of the services over ZeroMQ, without scheme. */
  externalAddressServiceZmq: string;
  /** Host, port and path of the services as JSON over HTTP, without scheme. */
  externalAddressServiceHttpJson: string;
  /** Host, port and path of the services as protobuf over HTTP, without scheme. */
  externalAddressServiceHttpBinary: string;
  /** Host and port of the topic data over ZeroMQ, without scheme. */
  externalAddressTopicDataZmq: string;
  /** Host and port of the topic data over WebSocket, without scheme. */
  externalAddressTopicDataWs: string;
}

/**
 * A named call a master answers.
 *
 * `ubii.services.Service`
 */
export interface Service {
  /** Its name. */
  topic: string;
  /** Full name of the message it takes; several are separated by ", ", empty when it takes none. */
  requestMessageFormat: string;
  /** Full name of the message it returns. */
  responseMessageFormat: string;
  /** Words to find it by. */
  tags: string[];
  /** What it does, one sentence. */
  description: string;
}

/**
 * Services; every topic once.
 *
 * `ubii.services.ServiceList`
 */
export interface ServiceList {
  /** In no promised order. */
  elements: Service[];
}

/**
 * The answer to a call. Exactly one member is set.
 *
 * `ubii.services.ServiceReply`
 */
export interface ServiceReply {
  /** Done; there is nothing else to return. */
  success?: Success | undefined;
  /** Refused or failed. Rule SV-5. */
  error?: ErrorMessage | undefined;
  /** A client. */
  client?: Client | undefined;
  /** A device. */
  device?: Device | undefined;
  /** A master. */
  server?: Server | undefined;
  /** A session. */
  session?: Session | undefined;
  /** Sessions. */
  sessionList?: SessionList | undefined;
  /** A module. */
  processingModule?: ProcessingModule | undefined;
  /** Modules. */
  processingModuleList?: ProcessingModuleList | undefined;
  /** Texts, for example topics. */
  stringList?: StringList | undefined;
  /** A multiplexer. */
  topicMux?: TopicMux | undefined;
  /** Multiplexers. */
  topicMuxList?: TopicMuxList | undefined;
  /** A demultiplexer. */
  topicDemux?: TopicDemux | undefined;
  /** Demultiplexers. */
  topicDemuxList?: TopicDemuxList | undefined;
  /** Clients. */
  clientList?: ClientList | undefined;
  /** Devices. */
  deviceList?: DeviceList | undefined;
  /** A service. */
  service?: Service | undefined;
  /** Services. */
  serviceList?: ServiceList | undefined;
  /** What lockstep modules put out. */
  lockstepProcessingReply?: LockstepProcessingReply | undefined;
  /** A component. */
  component?: Component | undefined;
  /** Components. */
  componentList?: ComponentList | undefined;
  /** A condition. */
  notifyCondition?: NotifyCondition | undefined;
  /** Counters of topics. Rule EX-11. */
  topicStatistics?: TopicStatistics | undefined;
  /** How the master is. Rule EX-16. */
  masterStatus?: MasterStatus | undefined;
  /** The nodes that can run modules. Rule PM-61. */
  nodeList?: NodeList | undefined;
  /** What clients do. Rule EX-25. */
  clientReport?: ClientReport | undefined;
  /** The limits in force. Rule EX-35. */
  limitList?: LimitList | undefined;
  /** Lines of the log. Rule EX-37. */
  logTail?: LogTail | undefined;
  /** Versions of a module. Rule EX-40. */
  moduleVersionList?: ModuleVersionList | undefined;
  /** What the master was started with. Rule EX-50. */
  settingList?: SettingList | undefined;
  /** Asset sets of the master. Rule EX-57. */
  assetSetList?: AssetSetList | undefined;
  /** Who receives the records of topics. Rule EX-95. */
  topicSubscribersList?: TopicSubscribersList | undefined;
  /** What a token is good for. Rule AC-16. */
  joinCheck?: JoinCheck | undefined;
  /** The invitation, with its secrets. Rule AC-11. */
  accessGrantCreated?: AccessGrantCreated | undefined;
  /** The invitation. Rule AC-15. */
  accessGrant?: AccessGrant | undefined;
  /** All invitations. Rule AC-14. */
  accessGrantList?: AccessGrantList | undefined;
  /** Entries of the audit log. Rule EX-93. */
  auditLog?: AuditLog | undefined;
  /** A recording. Rule RC-1. */
  recording?: Recording | undefined;
  /** All recordings. Rule RC-3. */
  recordingList?: RecordingList | undefined;
  /** The marker as it is now. Rule RC-20. */
  recordingMarker?: RecordingMarker | undefined;
  /** What a selection would record. Rule RC-15. */
  recordingEstimate?: RecordingEstimate | undefined;
  /** The flight recorder as it is now. Rule RC-30. */
  flightRecorder?: FlightRecorder | undefined;
  /** Records that the flight recorder holds. Rule RC-36. */
  flightRecords?: FlightRecords | undefined;
  /** A replay. Rule RP-1. */
  replay?: Replay | undefined;
  /** All replays. Rule RP-7. */
  replayList?: ReplayList | undefined;
  /** Labels of personal data. Rule PD-3. */
  personalData?: PersonalData | undefined;
  /** A study. Rule ST-1. */
  study?: Study | undefined;
  /** All studies. Rule ST-1. */
  studyList?: StudyList | undefined;
  /** A run of a study. Rule ST-20. */
  studyRun?: StudyRun | undefined;
  /** Runs of studies. Rule ST-20. */
  studyRunList?: StudyRunList | undefined;
  /** Required devices, as they are now. Rule ST-30. */
  studyCheckList?: StudyCheckList | undefined;
  /** Participants of studies. Rule ST-50. */
  studyParticipantList?: StudyParticipantList | undefined;
  /** What was deleted of a participant. Rule ST-51. */
  studyDeletion?: StudyDeletion | undefined;
  /** Proof that the master is of the cluster. */
  masterProof?: MasterProof | undefined;
  /** The mappings of a bridge. Rule BR-80. */
  bridgeMappings?: BridgeMappings | undefined;
}

/**
 * A call of a service. What each service takes is in the service table.
 *
 * `ubii.services.ServiceRequest`
 */
export interface ServiceRequest {
  /** Which service. */
  topic: string;
  /** A client, or the profile of one. */
  client?: Client | undefined;
  /** A device, or the profile of one. */
  device?: Device | undefined;
  /** Subscriptions to add and to end. */
  topicSubscription?: TopicSubscription | undefined;
  /** A session, or just its id. */
  session?: Session | undefined;
  /** Sessions. */
  sessionList?: SessionList | undefined;
  /** A module, or just its id or name. */
  processingModule?: ProcessingModule | undefined;
  /** Modules, or profiles of them. */
  processingModuleList?: ProcessingModuleList | undefined;
  /** A multiplexer. */
  topicMux?: TopicMux | undefined;
  /** Multiplexers. */
  topicMuxList?: TopicMuxList | undefined;
  /** A demultiplexer. */
  topicDemux?: TopicDemux | undefined;
  /** Demultiplexers. */
  topicDemuxList?: TopicDemuxList | undefined;
  /** Clients, or profiles of them. */
  clientList?: ClientList | undefined;
  /** Devices, or profiles of them. */
  deviceList?: DeviceList | undefined;
  /** One pass of lockstep modules. */
  lockstepProcessingRequest?: LockstepProcessingRequest | undefined;
  /** A component, or the profile of one. */
  component?: Component | undefined;
  /** Components, or profiles of them. */
  componentList?: ComponentList | undefined;
  /** A condition. */
  notifyCondition?: NotifyCondition | undefined;
  /** Which counters are wanted. Rule EX-11. */
  topicStatisticsRequest?: TopicStatisticsRequest | undefined;
  /** Which samples and events are wanted. Rule EX-16. */
  masterStatusRequest?: MasterStatusRequest | undefined;
  /** Which clients a report is wanted of. Rule EX-25. */
  clientReportRequest?: ClientReportRequest | undefined;
  /** Another name for a client. Rule EX-29. */
  clientRenameRequest?: ClientRenameRequest | undefined;
  /** Which client is to be removed. Rule EX-30. */
  clientDisconnectRequest?: ClientDisconnectRequest | undefined;
  /** Which client is to be throttled. Rule EX-31. */
  clientThrottleRequest?: ClientThrottleRequest | undefined;
  /** Which lines of the log are wanted. Rule EX-37. */
  logRequest?: LogRequest | undefined;
  /** Which versions of which module are wanted. Rule EX-40. */
  moduleVersionRequest?: ModuleVersionRequest | undefined;
  /** Which asset set is to be downloaded. Rule EX-58. */
  assetSetRequest?: AssetSetRequest | undefined;
  /** Topics whose subscribers are wanted. Rule EX-95. */
  topicSubscribersRequest?: TopicSubscribersRequest | undefined;
  /** A token to be checked. Rule AC-16. */
  joinCheckRequest?: JoinCheckRequest | undefined;
  /** The invitation that is wanted. Rule AC-10. */
  accessGrantCreateRequest?: AccessGrantCreateRequest | undefined;
  /** The invitation that is revoked. Rule AC-15. */
  accessGrantRevokeRequest?: AccessGrantRevokeRequest | undefined;
  /** Which entries of the audit log are wanted. Rule EX-93. */
  auditLogRequest?: AuditLogRequest | undefined;
  /** Which recording is meant. Rule RC-5. */
  recordingRequest?: RecordingRequest | undefined;
  /** A recording to start. Rule RC-4. */
  recordingStartRequest?: RecordingStartRequest | undefined;
  /** Name and notes of a recording. Rule RC-6. */
  recordingChangeRequest?: RecordingChangeRequest | undefined;
  /** A marker to add, change or remove. Rule RC-20. */
  recordingMarker?: RecordingMarker | undefined;
  /** What an estimate is wanted of. Rule RC-15. */
  recordingSelection?: RecordingSelection | undefined;
  /** What the flight recorder should keep. Rule RC-31. */
  flightRecorderSettings?: FlightRecorderSettings | undefined;
  /** What to keep of the flight recorder. Rule RC-32. */
  flightRecorderKeepRequest?: FlightRecorderKeepRequest | undefined;
  /** Of which topics to read what the flight recorder holds. Rule RC-36. */
  flightRecordsRequest?: FlightRecordsRequest | undefined;
  /** A replay to start. Rule RP-1. */
  replayStartRequest?: ReplayStartRequest | undefined;
  /** A change of a replay. Rule RP-5. */
  replayChangeRequest?: ReplayChangeRequest | undefined;
  /** Which replay is meant. Rule RP-6. */
  replayRequest?: ReplayRequest | undefined;
  /** Labels of personal data that replace those before. Rule PD-4. */
  personalData?: PersonalData | undefined;
  /** Which study is meant. Rule ST-1. */
  studyRequest?: StudyRequest | undefined;
  /** A study to create or replace. Rule ST-3. */
  study?: Study | undefined;
  /** A run to start. Rule ST-20. */
  studyRunStartRequest?: StudyRunStartRequest | undefined;
  /** What to do with a run. Rule ST-21. */
  studyRunChangeRequest?: StudyRunChangeRequest | undefined;
  /** Which run is meant. Rule ST-20. */
  studyRunRequest?: StudyRunRequest | undefined;
  /** Which runs to list. Rule ST-20. */
  studyRunListRequest?: StudyRunListRequest | undefined;
  /** Which participants are meant. Rule ST-50. */
  studyParticipantRequest?: StudyParticipantRequest | undefined;
  /** Asks a master to prove that it is of the cluster. */
  masterProofRequest?: MasterProofRequest | undefined;
  /** The bridge whose mappings are wanted. Rule BR-80. */
  bridgeMappingsRequest?: BridgeMappingsRequest | undefined;
  /** Mappings that a bridge is to check or to save. Rules BR-81 and BR-82. */
  bridgeMappingsChange?: BridgeMappingsChange | undefined;
}

/**
 * Changes what a client is subscribed to. Handled in the order topics, regular expressions,
 * components, each first subscribed, then unsubscribed. Rules TD-20 to TD-28, SV-12.
 *
 * `ubii.services.request.TopicSubscription`
 */
export interface TopicSubscription {
  /** The client that subscribes. */
  clientId: string;
  /** Topics to subscribe to. */
  subscribeTopics: string[];
  /** Topics to unsubscribe from. */
  unsubscribeTopics: string[];
  /** Regular expressions to subscribe to, RE2 syntax, unanchored. */
  subscribeTopicRegexp: string[];
  /** Regular expressions to unsubscribe from, spelt as when subscribed. */
  unsubscribeTopicRegexp: string[];
  /** Profiles: the topics of all components that match one are subscribed, future ones as well. */
  subscribeComponents: Component[];
  /** Profiles to unsubscribe from, equal to those subscribed. */
  unsubscribeComponents: Component[];
  /** Highest rate of records per topic for what is subscribed here, hertz; 0 is no limit. Rule EX-8. */
  maxRateHz: number;
}

/**
 * What flows into and out of one module.
 *
 * `ubii.sessions.IOMapping`
 */
export interface IOMapping {
  /** Id of the module. */
  processingModuleId: string;
  /** Its inputs; those without a mapping stay empty. */
  inputMappings: TopicInputMapping[];
  /** Its outputs; those without a mapping are dropped. */
  outputMappings: TopicOutputMapping[];
  /** Name of the module: Python nodes find it by name, the others by id. */
  processingModuleName: string;
}

/**
 * Mappings of several modules.
 *
 * `ubii.sessions.IOMappingList`
 */
export interface IOMappingList {
  /** In no promised order. */
  elements: IOMapping[];
}

/**
 * Modules that are started and stopped together, and what flows into and out of them.
 *
 * `ubii.sessions.Session`
 */
export interface Session {
  /** UUID, assigned by the master. */
  id: string;
  /** Display name; stored sessions are found by it. */
  name: string;
  /** Its modules. */
  processingModules: ProcessingModule[];
  /** What flows where, one entry a module. Existing nodes need at least one. */
  ioMappings: IOMapping[];
  /** Words to find it by. */
  tags: string[];
  /** Text for display. */
  description: string;
  /** Who made it. */
  authors: string[];
  /** Where it is in its life. */
  status: SessionStatus;
  /** False when editors should not offer to change it. */
  editable: boolean;
  /** What existing clients do not know of it. Rule EX-22. */
  extension: SessionExtension | undefined;
}

/**
 * Sessions.
 *
 * `ubii.sessions.SessionList`
 */
export interface SessionList {
  /** In no promised order. */
  elements: Session[];
}

/**
 * Where one input of a module gets its value.
 *
 * `ubii.sessions.TopicInputMapping`
 */
export interface TopicInputMapping {
  /** Internal name of the input. */
  inputName: string;
  /** The newest record of a topic. */
  topic?: string | undefined;
  /** The newest records of many topics, as a list. */
  topicMux?: TopicMux | undefined;
  /**
   * A value that never changes, in place of a topic: JSON text of the record's member, such as
   * {"vector2":{"x":1,"y":0}}. Rules EX-19 and PM-34.
   */
  constantJson: string;
}

/**
 * Mappings of inputs.
 *
 * `ubii.sessions.TopicInputMappingList`
 */
export interface TopicInputMappingList {
  /** In no promised order. */
  elements: TopicInputMapping[];
}

/**
 * Where one output of a module goes.
 *
 * `ubii.sessions.TopicOutputMapping`
 */
export interface TopicOutputMapping {
  /** Internal name of the output. */
  outputName: string;
  /** A topic. */
  topic?: string | undefined;
  /** Many topics, one for each element of the list. */
  topicDemux?: TopicDemux | undefined;
}

/**
 * Mappings of outputs.
 *
 * `ubii.sessions.TopicOutputMappingList`
 */
export interface TopicOutputMappingList {
  /** In no promised order. */
  elements: TopicOutputMapping[];
}

/**
 * When a value was taken, by the publisher's clock. The fields are independent: clients fill one or
 * the other, and not all of them with time since the Unix epoch.
 *
 * `ubii.topicData.Timestamp`
 */
export interface Timestamp {
  /** Whole seconds, by convention since the Unix epoch. */
  seconds: number;
  /** Fraction of the second, nanoseconds from 0 to 999999999. */
  nanos: number;
  /** The whole moment in milliseconds, by convention since the Unix epoch. */
  millis: number;
}

/**
 * What one frame of the topic-data channel holds.
 *
 * `ubii.topicData.TopicData`
 */
export interface TopicData {
  /** One record. */
  topicDataRecord?: TopicDataRecord | undefined;
  /** Several records. From a master only to clients that asked for lists. Rules TD-3, TD-4. */
  topicDataRecordList?: TopicDataRecordList | undefined;
  /** Why something was refused. Rule TD-17. */
  error?: ErrorMessage | undefined;
  /** Between the master and its nodes; never to or from existing clients. Rule EX-20. */
  nodeMessage?: NodeMessage | undefined;
}

/**
 * One value on a topic. A record without a value is allowed. The members are the data formats.
 *
 * `ubii.topicData.TopicDataRecord`
 */
export interface TopicDataRecord {
  /** Where it is published. */
  topic: string;
  /** When the value was taken. */
  timestamp: Timestamp | undefined;
  /** A number. */
  double?: number | undefined;
  /** A truth value. */
  bool?: boolean | undefined;
  /** A text. */
  string?: string | undefined;
  /** Two numbers. */
  vector2?: Vector2 | undefined;
  /** Three numbers. */
  vector3?: Vector3 | undefined;
  /** Four numbers. */
  vector4?: Vector4 | undefined;
  /** A rotation. */
  quaternion?: Quaternion | undefined;
  /** A matrix of 3 rows and 2 columns. */
  matrix3x2?: Matrix3x2 | undefined;
  /** A matrix of 4 rows and 4 columns. */
  matrix4x4?: Matrix4x4 | undefined;
  /** A colour. */
  color?: Color | undefined;
  /** A touch. An event: every record counts. */
  touchEvent?: TouchEventMessage | undefined;
  /** A key. An event: every record counts. */
  keyEvent?: KeyEvent | undefined;
  /** A mouse button. An event: every record counts. */
  mouseEvent?: MouseEventMessage | undefined;
  /** A measurement of an armband. An event: every record counts. */
  myoEvent?: MyoEvent | undefined;
  /** A position and orientation in the plane. */
  pose2D?: Pose2D | undefined;
  /** A position and orientation in space. */
  pose3D?: Pose3D | undefined;
  /** A thing in the plane. */
  object2D?: Object2D | undefined;
  /** A thing in space. */
  object3D?: Object3D | undefined;
  /** Things in the plane. */
  object2DList?: Object2DList | undefined;
  /** Things in space. */
  object3DList?: Object3DList | undefined;
  /** An integer. */
  int32?: number | undefined;
  /** A number of single precision. */
  float?: number | undefined;
  /** Integers. */
  int32List?: Int32List | undefined;
  /** Numbers of single precision. */
  floatList?: FloatList | undefined;
  /** Numbers. */
  doubleList?: DoubleList | undefined;
  /** Texts. */
  stringList?: StringList | undefined;
  /** Truth values. */
  boolList?: BoolList | undefined;
  /** A picture. */
  image2D?: Image2D | undefined;
  /** Pictures. */
  image2DList?: Image2DList | undefined;
  /** News of a session. */
  session?: Session | undefined;
  /** Id of the publisher, as far as it says; never checked. */
  clientId: string;
  /** Touches. An event: every record counts. */
  touchEventList?: TouchEventList | undefined;
  /** Pairs of numbers. */
  vector2List?: Vector2List | undefined;
  /** Triples of numbers. */
  vector3List?: Vector3List | undefined;
  /** Quadruples of numbers. */
  vector4List?: Vector4List | undefined;
  /** A single rotation in spite of the name: existing clients send and expect this type. */
  quaternionList?: Quaternion | undefined;
  /** News of something that went wrong. */
  error?: ErrorMessage | undefined;
  /** News of a device. */
  device?: Device | undefined;
  /** Devices. */
  deviceList?: DeviceList | undefined;
  /** A component. */
  component?: Component | undefined;
  /** Components. */
  componentList?: ComponentList | undefined;
  /** Sessions. */
  sessionList?: SessionList | undefined;
  /** News of a client. Rule CL-31. */
  client?: Client | undefined;
  /** How a running session does. Rules EX-23 and SE-50. */
  sessionStatistics?: SessionStatistics | undefined;
  /** Something a running module did. An event: every record counts. Rules EX-23 and SE-51. */
  moduleEvent?: ModuleEvent | undefined;
  /** Our extensions: how long the value outlives its publisher. Rule TD-43. */
  extension: RecordExtension | undefined;
  /** What is recorded now. Rule RC-8. */
  recordingStatus?: RecordingStatus | undefined;
  /** All replays. Rule RP-7. */
  replayList?: ReplayList | undefined;
  /** Open runs and check lists of studies. Rule ST-40. */
  studyStatus?: StudyStatus | undefined;
}

/**
 * Records that travel together.
 *
 * `ubii.topicData.TopicDataRecordList`
 */
export interface TopicDataRecordList {
  /** In publishing order. Rule TD-10. */
  elements: TopicDataRecord[];
}

/**
 * Where a value comes from. Kept for compatibility: no other message refers to it.
 *
 * `ubii.topicData.TopicDataSource`
 */
export interface TopicDataSource {
  /** A topic. */
  topic?: string | undefined;
  /** All topics a regular expression matches, unanchored. */
  regex?: string | undefined;
  /** The topics of all components that match this profile. */
  component?: Component | undefined;
  /** No topic: always this record. */
  staticRecord?: TopicDataRecord | undefined;
}

/**
 * Sources.
 *
 * `ubii.topicData.TopicDataSourceList`
 */
export interface TopicDataSourceList {
  /** In no promised order. */
  elements: TopicDataSource[];
}

/** Every message of the schema by its full name. */
export interface MessageTypes {
  'ubii.clients.Client': Client;
  'ubii.clients.ClientList': ClientList;
  'ubii.conditions.NotifyCondition': NotifyCondition;
  'ubii.dataStructure.BoolList': BoolList;
  'ubii.dataStructure.Color': Color;
  'ubii.dataStructure.DoubleList': DoubleList;
  'ubii.dataStructure.FloatList': FloatList;
  'ubii.dataStructure.Image2D': Image2D;
  'ubii.dataStructure.Image2DList': Image2DList;
  'ubii.dataStructure.Int32List': Int32List;
  'ubii.dataStructure.KeyEvent': KeyEvent;
  'ubii.dataStructure.Matrix3x2': Matrix3x2;
  'ubii.dataStructure.Matrix4x4': Matrix4x4;
  'ubii.dataStructure.MouseEvent': MouseEventMessage;
  'ubii.dataStructure.MyoEvent': MyoEvent;
  'ubii.dataStructure.Object2D': Object2D;
  'ubii.dataStructure.Object2DList': Object2DList;
  'ubii.dataStructure.Object3D': Object3D;
  'ubii.dataStructure.Object3DList': Object3DList;
  'ubii.dataStructure.Pose2D': Pose2D;
  'ubii.dataStructure.Pose3D': Pose3D;
  'ubii.dataStructure.Quaternion': Quaternion;
  'ubii.dataStructure.QuaternionList': QuaternionList;
  'ubii.dataStructure.StringList': StringList;
  'ubii.dataStructure.TouchEvent': TouchEventMessage;
  'ubii.dataStructure.TouchEventList': TouchEventList;
  'ubii.dataStructure.Vector2': Vector2;
  'ubii.dataStructure.Vector2List': Vector2List;
  'ubii.dataStructure.Vector3': Vector3;
  'ubii.dataStructure.Vector3List': Vector3List;
  'ubii.dataStructure.Vector4': Vector4;
  'ubii.dataStructure.Vector4List': Vector4List;
  'ubii.dataStructure.Vector8': Vector8;
  'ubii.dataStructure.Vector8List': Vector8List;
  'ubii.devices.Component': Component;
  'ubii.devices.ComponentList': ComponentList;
  'ubii.devices.Device': Device;
  'ubii.devices.DeviceList': DeviceList;
  'ubii.devices.TopicDemux': TopicDemux;
  'ubii.devices.TopicDemuxList': TopicDemuxList;
  'ubii.devices.TopicMux': TopicMux;
  'ubii.devices.TopicMuxList': TopicMuxList;
  'ubii.extension.AccessGrant': AccessGrant;
  'ubii.extension.AccessGrantCreateRequest': AccessGrantCreateRequest;
  'ubii.extension.AccessGrantCreated': AccessGrantCreated;
  'ubii.extension.AccessGrantList': AccessGrantList;
  'ubii.extension.AccessGrantRevokeRequest': AccessGrantRevokeRequest;
  'ubii.extension.AssetSet': AssetSet;
  'ubii.extension.AssetSetDownload': AssetSetDownload;
  'ubii.extension.AssetSetList': AssetSetList;
  'ubii.extension.AssetSetRequest': AssetSetRequest;
  'ubii.extension.AuditEntry': AuditEntry;
  'ubii.extension.AuditLog': AuditLog;
  'ubii.extension.AuditLogRequest': AuditLogRequest;
  'ubii.extension.BridgeAnswer': BridgeAnswer;
  'ubii.extension.BridgeMappingProblem': BridgeMappingProblem;
  'ubii.extension.BridgeMappings': BridgeMappings;
  'ubii.extension.BridgeMappingsChange': BridgeMappingsChange;
  'ubii.extension.BridgeMappingsRequest': BridgeMappingsRequest;
  'ubii.extension.BridgeMatch': BridgeMatch;
  'ubii.extension.BridgeOrder': BridgeOrder;
  'ubii.extension.ClientActivity': ClientActivity;
  'ubii.extension.ClientClock': ClientClock;
  'ubii.extension.ClientDisconnectRequest': ClientDisconnectRequest;
  'ubii.extension.ClientExtension': ClientExtension;
  'ubii.extension.ClientRenameRequest': ClientRenameRequest;
  'ubii.extension.ClientReport': ClientReport;
  'ubii.extension.ClientReportRequest': ClientReportRequest;
  'ubii.extension.ClientSubscription': ClientSubscription;
  'ubii.extension.ClientThrottle': ClientThrottle;
  'ubii.extension.ClientThrottleRequest': ClientThrottleRequest;
  'ubii.extension.ClusterCall': ClusterCall;
  'ubii.extension.ClusterClient': ClusterClient;
  'ubii.extension.ClusterClientBytes': ClusterClientBytes;
  'ubii.extension.ClusterGoodbye': ClusterGoodbye;
  'ubii.extension.ClusterHello': ClusterHello;
  'ubii.extension.ClusterInterest': ClusterInterest;
  'ubii.extension.ClusterListen': ClusterListen;
  'ubii.extension.ClusterMaster': ClusterMaster;
  'ubii.extension.ClusterMessage': ClusterMessage;
  'ubii.extension.ClusterPart': ClusterPart;
  'ubii.extension.ClusterRecords': ClusterRecords;
  'ubii.extension.ClusterReply': ClusterReply;
  'ubii.extension.ClusterSessionNews': ClusterSessionNews;
  'ubii.extension.ClusterStatus': ClusterStatus;
  'ubii.extension.EndedTopics': EndedTopics;
  'ubii.extension.FlightRecorder': FlightRecorder;
  'ubii.extension.FlightRecorderKeepRequest': FlightRecorderKeepRequest;
  'ubii.extension.FlightRecorderSettings': FlightRecorderSettings;
  'ubii.extension.FlightRecords': FlightRecords;
  'ubii.extension.FlightRecordsRequest': FlightRecordsRequest;
  'ubii.extension.JoinCheck': JoinCheck;
  'ubii.extension.JoinCheckRequest': JoinCheckRequest;
  'ubii.extension.JoinRefusal': JoinRefusal;
  'ubii.extension.Limit': Limit;
  'ubii.extension.LimitList': LimitList;
  'ubii.extension.LimitUse': LimitUse;
  'ubii.extension.LogField': LogField;
  'ubii.extension.LogLine': LogLine;
  'ubii.extension.LogRequest': LogRequest;
  'ubii.extension.LogTail': LogTail;
  'ubii.extension.Mark': Mark;
  'ubii.extension.MasterAddress': MasterAddress;
  'ubii.extension.MasterProof': MasterProof;
  'ubii.extension.MasterProofRequest': MasterProofRequest;
  'ubii.extension.MasterStatus': MasterStatus;
  'ubii.extension.MasterStatusRequest': MasterStatusRequest;
  'ubii.extension.ModuleEvent': ModuleEvent;
  'ubii.extension.ModuleExtension': ModuleExtension;
  'ubii.extension.ModuleReports': ModuleReports;
  'ubii.extension.ModuleStatistics': ModuleStatistics;
  'ubii.extension.ModuleVersion': ModuleVersion;
  'ubii.extension.ModuleVersionList': ModuleVersionList;
  'ubii.extension.ModuleVersionRequest': ModuleVersionRequest;
  'ubii.extension.NodeExtension': NodeExtension;
  'ubii.extension.NodeInfo': NodeInfo;
  'ubii.extension.NodeList': NodeList;
  'ubii.extension.NodeMessage': NodeMessage;
  'ubii.extension.NodeRecorderAnswer': NodeRecorderAnswer;
  'ubii.extension.NodeRecorderClock': NodeRecorderClock;
  'ubii.extension.NodeRecorderFacts': NodeRecorderFacts;
  'ubii.extension.NodeRecorderMark': NodeRecorderMark;
  'ubii.extension.NodeRecorderOrder': NodeRecorderOrder;
  'ubii.extension.NodeRecorderReport': NodeRecorderReport;
  'ubii.extension.NodeRecorderSource': NodeRecorderSource;
  'ubii.extension.NodeRecorderSources': NodeRecorderSources;
  'ubii.extension.NodeRecorderStart': NodeRecorderStart;
  'ubii.extension.PersonalData': PersonalData;
  'ubii.extension.PersonalLabel': PersonalLabel;
  'ubii.extension.RecordExtension': RecordExtension;
  'ubii.extension.Recording': Recording;
  'ubii.extension.RecordingBudget': RecordingBudget;
  'ubii.extension.RecordingChangeRequest': RecordingChangeRequest;
  'ubii.extension.RecordingEstimate': RecordingEstimate;
  'ubii.extension.RecordingList': RecordingList;
  'ubii.extension.RecordingMarker': RecordingMarker;
  'ubii.extension.RecordingRequest': RecordingRequest;
  'ubii.extension.RecordingSelection': RecordingSelection;
  'ubii.extension.RecordingStartRequest': RecordingStartRequest;
  'ubii.extension.RecordingStatus': RecordingStatus;
  'ubii.extension.RecordingStudy': RecordingStudy;
  'ubii.extension.RecordingTopic': RecordingTopic;
  'ubii.extension.RecordingTopicRate': RecordingTopicRate;
  'ubii.extension.Replay': Replay;
  'ubii.extension.ReplayChangeRequest': ReplayChangeRequest;
  'ubii.extension.ReplayList': ReplayList;
  'ubii.extension.ReplayLoop': ReplayLoop;
  'ubii.extension.ReplayRename': ReplayRename;
  'ubii.extension.ReplayRequest': ReplayRequest;
  'ubii.extension.ReplaySeek': ReplaySeek;
  'ubii.extension.ReplaySpan': ReplaySpan;
  'ubii.extension.ReplayStartRequest': ReplayStartRequest;
  'ubii.extension.ReplayedSession': ReplayedSession;
  'ubii.extension.SessionExtension': SessionExtension;
  'ubii.extension.SessionProblem': SessionProblem;
  'ubii.extension.SessionStatistics': SessionStatistics;
  'ubii.extension.Setting': Setting;
  'ubii.extension.SettingList': SettingList;
  'ubii.extension.StatusEvent': StatusEvent;
  'ubii.extension.StatusProblem': StatusProblem;
  'ubii.extension.StatusSample': StatusSample;
  'ubii.extension.Study': Study;
  'ubii.extension.StudyBlock': StudyBlock;
  'ubii.extension.StudyCheckItem': StudyCheckItem;
  'ubii.extension.StudyCheckList': StudyCheckList;
  'ubii.extension.StudyCheckRow': StudyCheckRow;
  'ubii.extension.StudyCondition': StudyCondition;
  'ubii.extension.StudyConsent': StudyConsent;
  'ubii.extension.StudyConsentText': StudyConsentText;
  'ubii.extension.StudyDeletion': StudyDeletion;
  'ubii.extension.StudyDevice': StudyDevice;
  'ubii.extension.StudyList': StudyList;
  'ubii.extension.StudyNote': StudyNote;
  'ubii.extension.StudyOtherRecording': StudyOtherRecording;
  'ubii.extension.StudyParticipant': StudyParticipant;
  'ubii.extension.StudyParticipantList': StudyParticipantList;
  'ubii.extension.StudyParticipantRequest': StudyParticipantRequest;
  'ubii.extension.StudyRequest': StudyRequest;
  'ubii.extension.StudyRun': StudyRun;
  'ubii.extension.StudyRunChangeRequest': StudyRunChangeRequest;
  'ubii.extension.StudyRunList': StudyRunList;
  'ubii.extension.StudyRunListRequest': StudyRunListRequest;
  'ubii.extension.StudyRunNews': StudyRunNews;
  'ubii.extension.StudyRunRequest': StudyRunRequest;
  'ubii.extension.StudyRunStartRequest': StudyRunStartRequest;
  'ubii.extension.StudyStatus': StudyStatus;
  'ubii.extension.StudyTake': StudyTake;
  'ubii.extension.SubscribedModule': SubscribedModule;
  'ubii.extension.TakenMark': TakenMark;
  'ubii.extension.TopicStatistic': TopicStatistic;
  'ubii.extension.TopicStatistics': TopicStatistics;
  'ubii.extension.TopicStatisticsRequest': TopicStatisticsRequest;
  'ubii.extension.TopicSubscribers': TopicSubscribers;
  'ubii.extension.TopicSubscribersList': TopicSubscribersList;
  'ubii.extension.TopicSubscribersRequest': TopicSubscribersRequest;
  'ubii.general.Error': ErrorMessage;
  'ubii.general.ErrorList': ErrorList;
  'ubii.general.Success': Success;
  'ubii.general.SuccessList': SuccessList;
  'ubii.processing.LockstepProcessingReply': LockstepProcessingReply;
  'ubii.processing.LockstepProcessingRequest': LockstepProcessingRequest;
  'ubii.processing.ModuleIO': ModuleIO;
  'ubii.processing.ProcessingMode': ProcessingMode;
  'ubii.processing.ProcessingMode.Free': ProcessingModeFree;
  'ubii.processing.ProcessingMode.Frequency': ProcessingModeFrequency;
  'ubii.processing.ProcessingMode.Lockstep': ProcessingModeLockstep;
  'ubii.processing.ProcessingMode.TriggerOnInput': ProcessingModeTriggerOnInput;
  'ubii.processing.ProcessingModule': ProcessingModule;
  'ubii.processing.ProcessingModuleList': ProcessingModuleList;
  'ubii.servers.Server': Server;
  'ubii.services.Service': Service;
  'ubii.services.ServiceList': ServiceList;
  'ubii.services.ServiceReply': ServiceReply;
  'ubii.services.ServiceRequest': ServiceRequest;
  'ubii.services.request.TopicSubscription': TopicSubscription;
  'ubii.sessions.IOMapping': IOMapping;
  'ubii.sessions.IOMappingList': IOMappingList;
  'ubii.sessions.Session': Session;
  'ubii.sessions.SessionList': SessionList;
  'ubii.sessions.TopicInputMapping': TopicInputMapping;
  'ubii.sessions.TopicInputMappingList': TopicInputMappingList;
  'ubii.sessions.TopicOutputMapping': TopicOutputMapping;
  'ubii.sessions.TopicOutputMappingList': TopicOutputMappingList;
  'ubii.topicData.Timestamp': Timestamp;
  'ubii.topicData.TopicData': TopicData;
  'ubii.topicData.TopicDataRecord': TopicDataRecord;
  'ubii.topicData.TopicDataRecordList': TopicDataRecordList;
  'ubii.topicData.TopicDataSource': TopicDataSource;
  'ubii.topicData.TopicDataSourceList': TopicDataSourceList;
}
