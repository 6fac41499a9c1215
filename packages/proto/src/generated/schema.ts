// Made from schema/*.proto by scripts/generate.ts. Change the schema, then run `pnpm generate`.

/**
 * The whole schema as text, because it is small, compresses well and diffs line by line:
 * `enum <full name>` and its `<number> <name>` lines, `message <full name>` and its
 * `<number> <name> <type>[ *][ <oneof>]` lines; `*` marks a repeated field.
 */
export const SCHEMA_TEXT = `
enum ubii.clients.Client.State
0 ACTIVE
1 INACTIVE
2 UNAVAILABLE
enum ubii.dataStructure.ButtonEventType
0 UP
1 DOWN
enum ubii.dataStructure.HandGestureType
0 REST
1 FINGERS_SPREAD
2 WAVE_IN
3 WAVE_OUT
4 FIST
5 DOUBLE_TAP
enum ubii.dataStructure.Image2D.DataFormat
0 GRAY8
1 RGB8
2 RGBA8
enum ubii.dataStructure.TouchEvent.TouchEventType
0 TOUCH_START
1 TOUCH_MOVE
2 TOUCH_END
enum ubii.devices.Component.IOType
0 PUBLISHER
1 SUBSCRIBER
enum ubii.devices.Device.DeviceType
0 PARTICIPANT
1 WATCHER
enum ubii.extension.AccessRole
0 ACCESS_ROLE_NONE
1 ACCESS_ROLE_ADMIN
2 ACCESS_ROLE_PARTICIPANT
3 ACCESS_ROLE_PLAYER
4 ACCESS_ROLE_VIEWER
enum ubii.extension.AssetSetState
0 ASSET_SET_STATE_UNSPECIFIED
1 ASSET_SET_STATE_MISSING
2 ASSET_SET_STATE_PRESENT
3 ASSET_SET_STATE_DAMAGED
enum ubii.extension.AuditEntry.Way
0 GRANT
1 LOCAL
2 NETWORK
3 CLUSTER
enum ubii.extension.BridgeOutcome
0 BRIDGE_OUTCOME_UNSPECIFIED
1 BRIDGE_OUTCOME_SAVED
2 BRIDGE_OUTCOME_REFUSED
3 BRIDGE_OUTCOME_CONFLICT
enum ubii.extension.ClientActivity.AddressKind
0 UNKNOWN
1 LOOPBACK
2 PRIVATE
3 PUBLIC
enum ubii.extension.ClusterMaster.State
0 SELF
1 PRESENT
2 LOST
3 ENDED
enum ubii.extension.JoinProblem
0 JOIN_PROBLEM_NONE
1 JOIN_PROBLEM_MISSING
2 JOIN_PROBLEM_WRONG
3 JOIN_PROBLEM_EXPIRED
4 JOIN_PROBLEM_REVOKED
5 JOIN_PROBLEM_USED
6 JOIN_PROBLEM_GUESSING
7 JOIN_PROBLEM_ROLE
enum ubii.extension.LogLevel
0 LOG_ERROR
1 LOG_WARN
2 LOG_INFO
3 LOG_DEBUG
enum ubii.extension.MarkColour
0 MARK_COLOUR_NONE
1 MARK_COLOUR_CORAL
2 MARK_COLOUR_BLUE
3 MARK_COLOUR_YELLOW
4 MARK_COLOUR_GREEN
5 MARK_COLOUR_PINK
6 MARK_COLOUR_PETROL
7 MARK_COLOUR_PLUM
8 MARK_COLOUR_SKY
9 MARK_COLOUR_LIME
10 MARK_COLOUR_CHALK
11 MARK_COLOUR_BROWN
12 MARK_COLOUR_INK
enum ubii.extension.MarkShape
0 MARK_SHAPE_NONE
1 MARK_SHAPE_CIRCLE
2 MARK_SHAPE_TRIANGLE
3 MARK_SHAPE_SQUARE
4 MARK_SHAPE_STAR
5 MARK_SHAPE_DIAMOND
6 MARK_SHAPE_CROSS
7 MARK_SHAPE_HEXAGON
8 MARK_SHAPE_DROP
9 MARK_SHAPE_RING
10 MARK_SHAPE_MOON
11 MARK_SHAPE_FLOWER
12 MARK_SHAPE_HEART
enum ubii.extension.MasterAddress.Kind
0 LOOPBACK
1 WIFI
2 ETHERNET
3 VIRTUAL
4 PUBLIC
enum ubii.extension.ModuleEvent.Kind
0 ERROR
1 LOG
2 KILLED
3 RESTARTED
4 FAILED
5 REFUSED
6 OVERRUN
enum ubii.extension.ModuleOrigin
0 MODULE_ORIGIN_UNKNOWN
1 MODULE_ORIGIN_BUILT_IN
2 MODULE_ORIGIN_FOLDER
3 MODULE_ORIGIN_STORED
4 MODULE_ORIGIN_NODE
enum ubii.extension.ModuleVersion.Origin
0 SAVED
1 FILE
2 FOUND
enum ubii.extension.MuxIdentity
0 MUX_IDENTITY_PATTERN
1 MUX_IDENTITY_CLIENT_ID
2 MUX_IDENTITY_DEVICE_ID
3 MUX_IDENTITY_TOPIC
enum ubii.extension.NodeExtension.Kind
0 EXTERNAL
1 MASTER
2 NODE
3 BROWSER
enum ubii.extension.PersonalTreatment
0 PERSONAL_TREATMENT_DROP
1 PERSONAL_TREATMENT_PSEUDONYM
2 PERSONAL_TREATMENT_ROUND
enum ubii.extension.RecordingKind
0 RECORDING_KIND_RECORDING
1 RECORDING_KIND_FLIGHT_RECORDER
2 RECORDING_KIND_IMPORT
3 RECORDING_KIND_COMPARISON
enum ubii.extension.RecordingState
0 RECORDING_STATE_UNSPECIFIED
1 RECORDING_STATE_RECORDING
2 RECORDING_STATE_COMPLETE
3 RECORDING_STATE_REPAIRED
4 RECORDING_STATE_FAILED
5 RECORDING_STATE_AT_NODE
6 RECORDING_STATE_REJECTED
enum ubii.extension.ReplayAction
0 REPLAY_ACTION_NONE
1 REPLAY_ACTION_PLAY
2 REPLAY_ACTION_PAUSE
enum ubii.extension.ReplayConflict
0 REPLAY_CONFLICT_MUTE_LIVE
1 REPLAY_CONFLICT_MOVE_LIVE
2 REPLAY_CONFLICT_KEEP_LIVE
enum ubii.extension.ReplayState
0 REPLAY_STATE_UNSPECIFIED
1 REPLAY_STATE_PLAYING
2 REPLAY_STATE_PAUSED
3 REPLAY_STATE_ENDED
4 REPLAY_STATE_FAILED
enum ubii.extension.RevokedWork
0 REVOKED_WORK_STOP
1 REVOKED_WORK_HAND_OVER
enum ubii.extension.SessionState
0 SESSION_CREATED
1 SESSION_STARTING
2 SESSION_RUNNING
3 SESSION_DEGRADED
4 SESSION_PAUSED
5 SESSION_STOPPING
6 SESSION_STOPPED
enum ubii.extension.StatusEvent.Kind
0 CLIENT_JOINED
1 CLIENT_LEFT
2 CLIENT_LOST
3 CLIENT_RETURNED
4 LIMIT_REACHED
5 MASTER_STARTED
6 FILE_CHANGED
7 FILE_BROKEN
8 SESSION_DEGRADED
9 CLIENT_RENAMED
10 CLIENT_DISCONNECTED
11 CLIENT_THROTTLED
12 OVERLOAD
13 MASTER_JOINED
14 MASTER_LOST
15 SESSION_MOVED
enum ubii.extension.StatusProblem.Severity
0 WARNING
1 ERROR
enum ubii.extension.StudyBlockState
0 STUDY_BLOCK_STATE_PENDING
1 STUDY_BLOCK_STATE_RUNNING
2 STUDY_BLOCK_STATE_DONE
3 STUDY_BLOCK_STATE_SKIPPED
4 STUDY_BLOCK_STATE_INTERRUPTED
enum ubii.extension.StudyCheckKind
0 STUDY_CHECK_KIND_PRESENCE
1 STUDY_CHECK_KIND_RATE
2 STUDY_CHECK_KIND_BATTERY
3 STUDY_CHECK_KIND_CLOCK
enum ubii.extension.StudyCheckState
0 STUDY_CHECK_STATE_OK
1 STUDY_CHECK_STATE_MISSING
2 STUDY_CHECK_STATE_LOW
enum ubii.extension.StudyOrder
0 STUDY_ORDER_FIXED
1 STUDY_ORDER_RANDOM
2 STUDY_ORDER_BALANCED
enum ubii.extension.StudyRunAction
0 STUDY_RUN_ACTION_UNSPECIFIED
1 STUDY_RUN_ACTION_CONSENT
2 STUDY_RUN_ACTION_BEGIN_BLOCK
3 STUDY_RUN_ACTION_END_BLOCK
4 STUDY_RUN_ACTION_SKIP_BLOCK
5 STUDY_RUN_ACTION_REPEAT_BLOCK
6 STUDY_RUN_ACTION_NOTE
7 STUDY_RUN_ACTION_END
8 STUDY_RUN_ACTION_CONTINUE
enum ubii.extension.StudyRunState
0 STUDY_RUN_STATE_UNSPECIFIED
1 STUDY_RUN_STATE_OPEN
2 STUDY_RUN_STATE_INTERRUPTED
3 STUDY_RUN_STATE_ENDED
enum ubii.processing.ProcessingModule.Language
0 CPP
1 PY
2 JS
3 CS
4 JAVA
enum ubii.processing.ProcessingModule.Status
0 INITIALIZED
1 CREATED
2 PROCESSING
3 HALTED
4 DESTROYED
enum ubii.sessions.SessionStatus
0 CREATED
1 RUNNING
2 PAUSED
3 STOPPED
message ubii.clients.Client
1 id string
2 name string
3 devices ubii.devices.Device *
4 tags string *
5 description string
6 processing_modules ubii.processing.ProcessingModule *
7 is_dedicated_processing_node bool
8 host_ip string
9 metadata_json string
10 state ubii.clients.Client.State
11 latency float
1000 extension ubii.extension.ClientExtension
message ubii.clients.ClientList
1 elements ubii.clients.Client *
message ubii.conditions.NotifyCondition
1 id string
2 name string
3 evaluation_function_stringified string
4 client_profile_pub ubii.clients.Client
5 client_profile_sub ubii.clients.Client
message ubii.dataStructure.BoolList
1 elements bool *
message ubii.dataStructure.Color
1 r double
2 g double
3 b double
4 a double
message ubii.dataStructure.DoubleList
1 elements double *
message ubii.dataStructure.FloatList
1 elements float *
message ubii.dataStructure.Image2D
1 width int32
2 height int32
3 data_format ubii.dataStructure.Image2D.DataFormat
4 data bytes
message ubii.dataStructure.Image2DList
1 elements ubii.dataStructure.Image2D *
message ubii.dataStructure.Int32List
1 elements int32 *
message ubii.dataStructure.KeyEvent
1 type ubii.dataStructure.ButtonEventType
2 key string
message ubii.dataStructure.Matrix3x2
1 m00 double
2 m01 double
3 m10 double
4 m11 double
5 m20 double
6 m21 double
message ubii.dataStructure.Matrix4x4
1 m00 double
2 m01 double
3 m02 double
4 m03 double
5 m10 double
6 m11 double
7 m12 double
8 m13 double
9 m20 double
10 m21 double
11 m22 double
12 m23 double
13 m30 double
14 m31 double
15 m32 double
16 m33 double
message ubii.dataStructure.MouseEvent
1 type ubii.dataStructure.ButtonEventType
2 button int32
message ubii.dataStructure.MyoEvent
1 emg ubii.dataStructure.Vector8
2 orientation ubii.dataStructure.Quaternion
3 gyroscope ubii.dataStructure.Vector3
4 accelerometer ubii.dataStructure.Vector3
5 gesture ubii.dataStructure.HandGestureType
message ubii.dataStructure.Object2D
1 id string
2 pose ubii.dataStructure.Pose2D
3 size ubii.dataStructure.Vector2
4 user_data_json string
message ubii.dataStructure.Object2DList
1 elements ubii.dataStructure.Object2D *
message ubii.dataStructure.Object3D
1 id string
2 pose ubii.dataStructure.Pose3D
3 size ubii.dataStructure.Vector3
4 user_data_json string
message ubii.dataStructure.Object3DList
1 elements ubii.dataStructure.Object3D *
message ubii.dataStructure.Pose2D
1 position ubii.dataStructure.Vector2
2 direction ubii.dataStructure.Vector2 orientation
3 angle float orientation
message ubii.dataStructure.Pose3D
1 position ubii.dataStructure.Vector3
2 quaternion ubii.dataStructure.Quaternion orientation
3 euler ubii.dataStructure.Vector3 orientation
message ubii.dataStructure.Quaternion
1 x double
2 y double
3 z double
4 w double
message ubii.dataStructure.QuaternionList
1 elements ubii.dataStructure.Quaternion *
message ubii.dataStructure.StringList
1 elements string *
message ubii.dataStructure.TouchEvent
1 type ubii.dataStructure.TouchEvent.TouchEventType
2 position ubii.dataStructure.Vector2
3 id string
4 force float
message ubii.dataStructure.TouchEventList
1 elements ubii.dataStructure.TouchEvent *
message ubii.dataStructure.Vector2
1 x double
2 y double
message ubii.dataStructure.Vector2List
1 elements ubii.dataStructure.Vector2 *
message ubii.dataStructure.Vector3
1 x double
2 y double
3 z double
message ubii.dataStructure.Vector3List
1 elements ubii.dataStructure.Vector3 *
message ubii.dataStructure.Vector4
1 x double
2 y double
3 z double
4 w double
message ubii.dataStructure.Vector4List
1 elements ubii.dataStructure.Vector4 *
message ubii.dataStructure.Vector8
1 v0 double
2 v1 double
3 v2 double
4 v3 double
5 v4 double
6 v5 double
7 v6 double
8 v7 double
message ubii.dataStructure.Vector8List
1 elements ubii.dataStructure.Vector8 *
message ubii.devices.Component
1 topic string
2 message_format string
3 io_type ubii.devices.Component.IOType
4 device_id string
5 tags string *
6 description string
7 id string
8 name string
9 notify_condition_ids string *
message ubii.devices.ComponentList
1 elements ubii.devices.Component *
message ubii.devices.Device
1 id string
2 name string
3 device_type ubii.devices.Device.DeviceType
4 components ubii.devices.Component *
5 client_id string
6 tags string *
7 description string
message ubii.devices.DeviceList
1 elements ubii.devices.Device *
message ubii.devices.TopicDemux
1 id string
2 name string
3 data_type string
4 output_topic_format string
message ubii.devices.TopicDemuxList
1 elements ubii.devices.TopicDemux *
message ubii.devices.TopicMux
1 id string
2 name string
3 data_type string
4 topic_selector string
5 identity_match_pattern string
1000 topic_glob string
1001 component ubii.devices.Component
1002 identity_source ubii.extension.MuxIdentity
1003 identity_group int32
message ubii.devices.TopicMuxList
1 elements ubii.devices.TopicMux *
message ubii.extension.AccessGrant
1 id string
2 label string
3 role ubii.extension.AccessRole
4 target string
5 created_ms double
6 expires_ms double
7 max_joins int32
8 read_topics string *
9 write_topics string *
10 revoked_ms double
11 joins int32
12 client_ids string *
13 is_terminal bool
14 code_expires_ms double
15 stays_until_ms double
16 session_ids string *
17 running_session_ids string *
18 stored_session_names string *
19 module_names string *
message ubii.extension.AccessGrantCreateRequest
1 client_id string
2 label string
3 role ubii.extension.AccessRole
4 target string
5 lifetime_ms double
6 max_joins int32
7 read_topics string *
8 write_topics string *
9 stay_ms double
message ubii.extension.AccessGrantCreated
1 grant ubii.extension.AccessGrant
2 token string
3 code string
message ubii.extension.AccessGrantList
1 elements ubii.extension.AccessGrant *
message ubii.extension.AccessGrantRevokeRequest
1 client_id string
2 grant_id string
3 reason string
4 work ubii.extension.RevokedWork
message ubii.extension.AssetSet
1 name string
2 description string
3 version string
4 licence string
5 source string
6 bytes double
7 files int32
8 state ubii.extension.AssetSetState
9 problem string
10 bundled bool
11 address string
12 folder string
13 download ubii.extension.AssetSetDownload
14 publisher_address string
message ubii.extension.AssetSetDownload
1 running bool
2 loaded_bytes double
3 total_bytes double
4 elapsed_ms double
5 error string
message ubii.extension.AssetSetList
1 elements ubii.extension.AssetSet *
message ubii.extension.AssetSetRequest
1 name string
message ubii.extension.AuditEntry
1 number double
2 time_ms double
3 service string
4 object string
5 error string
6 client_id string
7 client_name string
8 role ubii.extension.AccessRole
9 way ubii.extension.AuditEntry.Way
10 grant_id string
11 grant_label string
12 address_kind ubii.extension.ClientActivity.AddressKind
13 left_out int32
14 master_name string
message ubii.extension.AuditLog
1 entries ubii.extension.AuditEntry *
2 more bool
3 kept int32
message ubii.extension.AuditLogRequest
1 before double
2 count int32
3 client_id string
4 grant_id string
5 service string
6 text string
message ubii.extension.BridgeAnswer
1 number int32
2 mappings ubii.extension.BridgeMappings
3 error ubii.general.Error
message ubii.extension.BridgeMappingProblem
1 index int32
2 member string
3 message string
message ubii.extension.BridgeMappings
1 protocol string
2 mappings_json string
3 revision string
4 file string
5 file_exists bool
6 file_problem string
7 outcome ubii.extension.BridgeOutcome
8 problems ubii.extension.BridgeMappingProblem *
9 matches ubii.extension.BridgeMatch *
10 more_matches int32
message ubii.extension.BridgeMappingsChange
1 target_id string
2 mappings_json string
3 revision string
4 preview_index int32
5 client_id string
message ubii.extension.BridgeMappingsRequest
1 target_id string
message ubii.extension.BridgeMatch
1 inward bool
2 source string
3 target string
4 is_example bool
message ubii.extension.BridgeOrder
1 number int32
2 get ubii.extension.BridgeMappingsRequest type
3 check ubii.extension.BridgeMappingsChange type
4 set ubii.extension.BridgeMappingsChange type
5 author string
message ubii.extension.ClientActivity
1 client_id string
2 first_seen_ms double
3 last_seen_ms double
4 connected bool
5 connected_ms double
6 round_trip_ms double
7 round_trip_age_ms double
8 records_in double
9 bytes_in double
10 records_out double
11 bytes_out double
12 records_in_per_second double
13 bytes_in_per_second double
14 records_out_per_second double
15 bytes_out_per_second double
16 queued_records int32
17 queued_bytes double
18 dropped double
19 refused double
20 protocol_errors double
21 topic_subscriptions int32
22 pattern_subscriptions int32
23 component_subscriptions int32
24 watches_everything bool
25 subscriptions ubii.extension.ClientSubscription *
26 owned_topics int32
27 user_agent string
28 library string
29 address_kind ubii.extension.ClientActivity.AddressKind
30 throttle ubii.extension.ClientThrottle
31 work_share double
40 role ubii.extension.AccessRole
41 grant_id string
42 clock ubii.extension.ClientClock
43 address_group string
message ubii.extension.ClientClock
1 offset_ms double
2 error_ms double
3 drift_ppm double
4 age_ms double
message ubii.extension.ClientDisconnectRequest
1 client_id string
2 target_id string
3 reason string
message ubii.extension.ClientExtension
1 record_lists bool
2 resume_token string
3 resumed bool
4 master_version string
5 node ubii.extension.NodeExtension
6 library string
7 sent_ms double
10 credential string
11 credential_expires_ms double
12 role ubii.extension.AccessRole
20 tells_time bool
25 masters string *
26 master_id string
30 abridged bool
31 registration_revision int32
40 mark ubii.extension.Mark
message ubii.extension.ClientRenameRequest
1 client_id string
2 target_id string
3 name string
message ubii.extension.ClientReport
1 master_time_ms double
2 measured_ms double
3 clients ubii.extension.ClientActivity *
message ubii.extension.ClientReportRequest
1 client_ids string *
2 subscriptions bool
message ubii.extension.ClientSubscription
1 topic string
2 pattern string
3 component ubii.devices.Component
4 max_rate_hz double
message ubii.extension.ClientThrottle
1 records_per_second double
2 by_policy bool
3 by_name string
4 reason string
5 since_ms double
6 dropped double
message ubii.extension.ClientThrottleRequest
1 client_id string
2 target_id string
3 records_per_second double
4 reason string
message ubii.extension.ClusterCall
1 number int32
2 request bytes
3 standing string
4 place string
5 address string
6 bearer string
7 is_here bool
message ubii.extension.ClusterClient
1 client ubii.clients.Client
2 is_extension bool
3 node ubii.extension.NodeExtension
4 library string
5 role ubii.extension.AccessRole
6 grant_id string
7 here_since_ms double
8 access_kind string
message ubii.extension.ClusterClientBytes
1 client_id string
2 bytes bytes
message ubii.extension.ClusterGoodbye
message ubii.extension.ClusterHello
1 version int32
2 name string
3 addresses string *
4 master_version string
5 started_ms double
6 installation string
message ubii.extension.ClusterInterest
1 topic string
2 pattern string
3 profile ubii.devices.Component
4 everything bool
5 max_rate_hz double
message ubii.extension.ClusterListen
1 stream int32
message ubii.extension.ClusterMaster
1 id string
2 name string
3 state ubii.extension.ClusterMaster.State
4 since_ms double
5 version string
6 started_ms double
7 addresses string *
8 clients int32
9 sessions int32
10 round_trip_ms double
11 records_to double
12 records_from double
13 records_to_per_second double
14 records_from_per_second double
15 bytes_to_per_second double
16 bytes_from_per_second double
17 queued_records double
18 dropped double
19 gaps double
20 complete bool
message ubii.extension.ClusterMessage
1 hello ubii.extension.ClusterHello type
2 goodbye ubii.extension.ClusterGoodbye type
3 listen ubii.extension.ClusterListen type
4 part ubii.extension.ClusterPart type
5 call ubii.extension.ClusterCall type
6 reply ubii.extension.ClusterReply type
15 proof bytes
message ubii.extension.ClusterPart
1 stream int32
2 number int32
3 clients ubii.extension.ClusterClient *
4 gone_clients string *
5 wanted ubii.extension.ClusterInterest *
6 unwanted ubii.extension.ClusterInterest *
7 values ubii.extension.ClusterRecords
8 records ubii.extension.ClusterRecords
9 complete bool
10 session_news ubii.extension.ClusterSessionNews *
11 frames ubii.extension.ClusterClientBytes *
12 node_messages ubii.extension.ClusterClientBytes *
13 sent_ms double
14 echo_ms double
15 held_ms double
message ubii.extension.ClusterRecords
1 records bytes *
2 stamps double *
3 publishers int32 *
4 publisher_ids string *
message ubii.extension.ClusterReply
1 number int32
2 reply bytes
message ubii.extension.ClusterSessionNews
1 topic string
2 session ubii.sessions.Session
message ubii.extension.ClusterStatus
1 name string
2 reachable bool
3 reachable_since_ms double
4 queued_bytes double
5 gaps double
6 masters ubii.extension.ClusterMaster *
message ubii.extension.EndedTopics
1 topics string *
message ubii.extension.FlightRecorder
1 is_on bool
2 minutes double
3 max_bytes double
4 with_images bool
5 held_ms double
6 held_bytes double
7 topic_count int32
8 record_count double
9 records_per_second double *
10 lost_count double
message ubii.extension.FlightRecorderKeepRequest
1 client_id string
2 name string
3 notes string
message ubii.extension.FlightRecorderSettings
1 is_on bool
2 minutes double
3 max_bytes double
4 with_images bool
message ubii.extension.FlightRecords
1 times_ms double *
2 lengths int32 *
3 records bytes
message ubii.extension.FlightRecordsRequest
1 client_id string
2 topics string *
3 since_ms double
message ubii.extension.JoinCheck
1 role ubii.extension.AccessRole
2 problem ubii.extension.JoinProblem
3 message string
4 target string
5 expires_ms double
6 master_name string
7 is_joined bool
8 free_mark ubii.extension.Mark
9 taken_marks ubii.extension.TakenMark *
message ubii.extension.JoinCheckRequest
1 token string
message ubii.extension.JoinRefusal
1 problem ubii.extension.JoinProblem
message ubii.extension.Limit
1 name string
2 value double
3 unit string
4 reason string
5 group string
6 use ubii.extension.LimitUse
7 hits double
message ubii.extension.LimitList
1 elements ubii.extension.Limit *
message ubii.extension.LimitUse
1 value double
2 client_id string
3 session_id string
message ubii.extension.LogField
1 name string
2 value string
message ubii.extension.LogLine
1 number double
2 time_ms double
3 level ubii.extension.LogLevel
4 message string
5 fields ubii.extension.LogField *
message ubii.extension.LogRequest
1 cursor double
2 level ubii.extension.LogLevel
3 count int32
message ubii.extension.LogTail
1 cursor double
2 reset bool
3 missed double
4 lines ubii.extension.LogLine *
message ubii.extension.Mark
1 shape ubii.extension.MarkShape
2 colour ubii.extension.MarkColour
3 chosen bool
message ubii.extension.MasterAddress
1 kind ubii.extension.MasterAddress.Kind
2 interface_name string
3 url string
message ubii.extension.MasterProof
1 proof string
message ubii.extension.MasterProofRequest
1 target_id string
2 host string
3 nonce string
message ubii.extension.MasterStatus
1 master_id string
2 name string
3 version string
4 started_ms double
5 now_ms double
6 records_in double
7 records_out double
8 bytes_in double
9 bytes_out double
10 dropped double
11 refused double
12 topics int32
13 clients_active int32
14 clients_inactive int32
15 clients_unavailable int32
16 cpu_percent float
17 memory_bytes double
18 samples ubii.extension.StatusSample *
19 events ubii.extension.StatusEvent *
20 problems ubii.extension.StatusProblem *
21 addresses ubii.extension.MasterAddress *
22 busy_percent double
23 delay_ms double
24 processors int32
25 cluster ubii.extension.ClusterStatus
message ubii.extension.MasterStatusRequest
1 since_ms double
message ubii.extension.ModuleEvent
1 session_id string
2 module_id string
3 module_name string
4 node_id string
5 kind ubii.extension.ModuleEvent.Kind
6 time_ms double
7 phase string
8 message string
9 line int32
10 column int32
11 level string
12 suppressed int32
message ubii.extension.ModuleExtension
1 version string
2 libraries string *
3 replaceable bool
4 origin ubii.extension.ModuleOrigin
5 grant_ids string *
6 assets string *
7 optional_assets string *
message ubii.extension.ModuleReports
1 statistics ubii.extension.ModuleStatistics *
2 events ubii.extension.ModuleEvent *
message ubii.extension.ModuleStatistics
1 module_id string
2 module_name string
3 node_id string
4 status ubii.processing.ProcessingModule.Status
5 runs double
6 runs_per_second double
7 run_p50_ms double
8 run_p95_ms double
9 overruns double
10 errors double
11 restarts double
12 outputs double
13 outputs_refused double
14 waiting int32
15 topics int32
16 topics_refused double
17 refused_output string
18 memory_bytes double
19 loading_set string
20 loaded_bytes double
21 loading_bytes double
message ubii.extension.ModuleVersion
1 number int32
2 time_ms double
3 origin ubii.extension.ModuleVersion.Origin
4 version string
5 byte_length int32
6 current bool
7 module ubii.processing.ProcessingModule
message ubii.extension.ModuleVersionList
1 elements ubii.extension.ModuleVersion *
message ubii.extension.ModuleVersionRequest
1 name string
2 module_id string
3 number int32
message ubii.extension.NodeExtension
1 kind ubii.extension.NodeExtension.Kind
2 runs_javascript bool
3 accepts_work bool
4 libraries string *
5 capacity int32
6 memory_bytes double
7 loads_assets bool
8 records bool
9 is_bridge bool
message ubii.extension.NodeInfo
1 client_id string
2 name string
3 node ubii.extension.NodeExtension
4 module_names string *
5 instances int32
6 available bool
7 dedicated bool
8 memory_bytes double
message ubii.extension.NodeList
1 elements ubii.extension.NodeInfo *
message ubii.extension.NodeMessage
1 lockstep_request ubii.processing.LockstepProcessingRequest type
2 lockstep_reply ubii.processing.LockstepProcessingReply type
3 module_reports ubii.extension.ModuleReports type
4 ended_topics ubii.extension.EndedTopics type
5 recorder_order ubii.extension.NodeRecorderOrder type
6 recorder_answer ubii.extension.NodeRecorderAnswer type
7 recorder_report ubii.extension.NodeRecorderReport type
8 bridge_order ubii.extension.BridgeOrder type
9 bridge_answer ubii.extension.BridgeAnswer type
message ubii.extension.NodeRecorderAnswer
1 number int32
2 recording ubii.extension.Recording
3 marker ubii.extension.RecordingMarker
4 error ubii.general.Error
message ubii.extension.NodeRecorderClock
1 client_id string
2 clock ubii.extension.ClientClock
message ubii.extension.NodeRecorderFacts
1 clocks ubii.extension.NodeRecorderClock *
2 lost_count double
3 lost_from_ms double
4 lost_until_ms double
message ubii.extension.NodeRecorderMark
1 marker ubii.extension.RecordingMarker
2 may_change_all bool
3 is_topic bool
message ubii.extension.NodeRecorderOrder
1 number int32
2 start ubii.extension.NodeRecorderStart type
3 stop ubii.extension.RecordingRequest type
4 get ubii.extension.RecordingRequest type
5 change ubii.extension.RecordingChangeRequest type
6 remove ubii.extension.RecordingRequest type
7 mark ubii.extension.NodeRecorderMark type
8 upload ubii.extension.RecordingRequest type
9 sources ubii.extension.NodeRecorderSources type
10 facts ubii.extension.NodeRecorderFacts type
message ubii.extension.NodeRecorderReport
1 elements ubii.extension.Recording *
message ubii.extension.NodeRecorderSource
1 topic string
2 client_id string
message ubii.extension.NodeRecorderSources
1 recording_id string
2 elements ubii.extension.NodeRecorderSource *
message ubii.extension.NodeRecorderStart
1 recording ubii.extension.Recording
2 maker_id string
3 master_name string
4 version string
5 personal_data string
6 sources ubii.extension.NodeRecorderSources
7 facts ubii.extension.NodeRecorderFacts
message ubii.extension.PersonalData
1 labels ubii.extension.PersonalLabel *
message ubii.extension.PersonalLabel
1 id string
2 topic_pattern string
3 field_path string
4 treatment ubii.extension.PersonalTreatment
5 step double
6 note string
message ubii.extension.RecordExtension
1 keep_seconds int32
2 expiry_ms int32
message ubii.extension.Recording
1 id string
2 name string
3 kind ubii.extension.RecordingKind
4 state ubii.extension.RecordingState
5 started_ms double
6 duration_ms double
7 size_bytes double
8 record_count double
9 lost_count double
10 topic_count int32
11 marker_count int32
12 problem string
13 notes string
14 author string
15 selection ubii.extension.RecordingSelection
16 budget ubii.extension.RecordingBudget
17 topics ubii.extension.RecordingTopic *
18 markers ubii.extension.RecordingMarker *
19 replayed_recording_id string
20 node_id string
21 node_name string
22 node_is_away bool
23 uploaded_bytes double
24 topics_from int32
25 topics_total int32
26 markers_from int32
30 study ubii.extension.RecordingStudy
message ubii.extension.RecordingBudget
1 max_duration_ms double
2 max_bytes double
3 min_free_bytes double
message ubii.extension.RecordingChangeRequest
1 id string
2 name string
3 notes string
message ubii.extension.RecordingEstimate
1 topics ubii.extension.RecordingTopicRate *
2 records_per_second double
3 bytes_per_second double
4 free_bytes double
message ubii.extension.RecordingList
1 elements ubii.extension.Recording *
2 size_bytes double
3 max_bytes double
4 free_bytes double
message ubii.extension.RecordingMarker
1 recording_id string
2 id string
3 time_ms double
4 text string
5 author string
6 client_id string
7 is_removed bool
message ubii.extension.RecordingRequest
1 id string
2 topics_from int32
3 markers_from int32
message ubii.extension.RecordingSelection
1 topics string *
2 patterns string *
3 clients string *
4 devices string *
5 sessions string *
6 excluded_patterns string *
7 without_images bool
message ubii.extension.RecordingStartRequest
1 client_id string
2 name string
3 notes string
4 selection ubii.extension.RecordingSelection
5 budget ubii.extension.RecordingBudget
6 node_id string
message ubii.extension.RecordingStatus
1 running ubii.extension.Recording *
2 flight_recorder ubii.extension.FlightRecorder
3 list_revision int32
message ubii.extension.RecordingStudy
1 study_id string
2 study_name string
3 run_id string
4 participant_code string
5 visit string
6 condition string
7 block int32
8 run_number int32
message ubii.extension.RecordingTopic
1 topic string
2 client_id string
3 client_name string
4 data_format string
5 record_count double
message ubii.extension.RecordingTopicRate
1 topic string
2 data_format string
3 records_per_second double
4 bytes_per_second double
message ubii.extension.Replay
1 id string
2 name string
3 recording_id string
4 recording_name string
5 author string
6 state ubii.extension.ReplayState
7 position_ms double
8 duration_ms double
9 rate double
10 span ubii.extension.ReplaySpan
11 is_looping bool
12 is_ghost bool
13 copies int32
14 client_ids string *
15 conflict ubii.extension.ReplayConflict
16 live_prefix string
17 topic_count int32
18 record_count double
19 muted_count double
20 muted_topics string *
21 refused_count double
22 problem string
23 session ubii.extension.ReplayedSession
24 started_ms double
25 recording_started_ms double
message ubii.extension.ReplayChangeRequest
1 id string
2 rate double
3 loop ubii.extension.ReplayLoop
4 seek ubii.extension.ReplaySeek
5 step int32
6 action ubii.extension.ReplayAction
message ubii.extension.ReplayList
1 elements ubii.extension.Replay *
message ubii.extension.ReplayLoop
1 span ubii.extension.ReplaySpan
2 is_looping bool
message ubii.extension.ReplayRename
1 from_prefix string
2 to_prefix string
message ubii.extension.ReplayRequest
1 id string
message ubii.extension.ReplaySeek
1 position_ms double
message ubii.extension.ReplaySpan
1 from_ms double
2 until_ms double
message ubii.extension.ReplayStartRequest
1 client_id string
2 recording_id string
3 topics string *
4 excluded_topics string *
5 renames ubii.extension.ReplayRename *
6 conflict ubii.extension.ReplayConflict
7 live_prefix string
8 rate double
9 is_paused bool
10 span ubii.extension.ReplaySpan
11 is_looping bool
12 keeps_timestamps bool
13 copies int32
14 jitter_ms double
15 is_ghost bool
16 name string
17 session_id string
message ubii.extension.ReplayedSession
1 session_id string
2 name string
3 running_id string
4 comparison_recording_id string
5 input_prefix string
6 output_prefix string
7 recorded_modules string *
message ubii.extension.SessionExtension
1 state ubii.extension.SessionState
2 problems ubii.extension.SessionProblem *
3 start_with_master bool
4 lockstep_hertz double
5 editor_json string
6 revision int32
7 stored bool
8 grant_ids string *
9 master_id string
10 moved_from string
11 moved_ms double
message ubii.extension.SessionProblem
1 is_error bool
2 code string
3 message string
4 path string
5 module_id string
6 module_name string
7 node_id string
8 line int32
9 column int32
message ubii.extension.SessionStatistics
1 session_id string
2 state ubii.extension.SessionState
3 time_ms double
4 modules ubii.extension.ModuleStatistics *
5 passes_per_second double
6 pass_p50_ms double
7 pass_p95_ms double
8 late_answers double
9 memory_limit_bytes double
message ubii.extension.Setting
1 flag string
2 value string
3 description string
4 given bool
message ubii.extension.SettingList
1 elements ubii.extension.Setting *
2 runtime string
message ubii.extension.StatusEvent
1 time_ms double
2 kind ubii.extension.StatusEvent.Kind
3 text string
4 client_id string
message ubii.extension.StatusProblem
1 code string
2 severity ubii.extension.StatusProblem.Severity
3 text string
4 client_id string
5 since_ms double
6 remedy string
7 session_id string
8 module_id string
message ubii.extension.StatusSample
1 time_ms double
2 records_per_second float
3 cpu_percent double
4 busy_percent double
5 delay_ms double
6 records_out_per_second double
message ubii.extension.Study
1 id string
2 name string
3 notes string
4 consent_text string
5 devices ubii.extension.StudyDevice *
6 conditions ubii.extension.StudyCondition *
7 order ubii.extension.StudyOrder
8 repetitions int32
9 block_ms double
10 selection ubii.extension.RecordingSelection
11 name_template string
12 revision int32
13 consent_version int32
14 earlier_consent_texts ubii.extension.StudyConsentText *
15 participant_count int32
16 run_count int32
17 changed_ms double
18 setting_patterns string *
message ubii.extension.StudyBlock
1 condition string
2 repetition int32
3 session_id string
4 state ubii.extension.StudyBlockState
5 takes ubii.extension.StudyTake *
message ubii.extension.StudyCheckItem
1 kind ubii.extension.StudyCheckKind
2 state ubii.extension.StudyCheckState
3 text string
message ubii.extension.StudyCheckList
1 study_id string
2 time_ms double
3 rows ubii.extension.StudyCheckRow *
4 is_ready bool
message ubii.extension.StudyCheckRow
1 name string
2 state ubii.extension.StudyCheckState
3 items ubii.extension.StudyCheckItem *
4 found string *
message ubii.extension.StudyCondition
1 name string
2 session_id string
message ubii.extension.StudyConsent
1 version int32
2 time_ms double
3 author string
message ubii.extension.StudyConsentText
1 version int32
2 text string
message ubii.extension.StudyDeletion
1 recording_names string *
2 size_bytes double
3 run_count int32
4 note_count int32
5 study_names string *
6 other_recordings ubii.extension.StudyOtherRecording *
message ubii.extension.StudyDevice
1 name string
2 topic_pattern string
3 data_format string
4 tag string
5 count int32
6 min_rate_hz double
7 min_battery double
8 max_clock_error_ms double
message ubii.extension.StudyList
1 elements ubii.extension.Study *
message ubii.extension.StudyNote
1 time_ms double
2 text string
3 author string
4 block int32
message ubii.extension.StudyOtherRecording
1 id string
2 name string
message ubii.extension.StudyParticipant
1 study_id string
2 code string
3 number int32
4 run_ids string *
5 recording_ids string *
6 size_bytes double
7 last_ms double
message ubii.extension.StudyParticipantList
1 elements ubii.extension.StudyParticipant *
message ubii.extension.StudyParticipantRequest
1 study_id string
2 participant_code string
message ubii.extension.StudyRequest
1 id string
message ubii.extension.StudyRun
1 id string
2 study_id string
3 participant_code string
4 participant_number int32
5 visit string
6 state ubii.extension.StudyRunState
7 revision int32
8 started_ms double
9 ended_ms double
10 consent ubii.extension.StudyConsent
11 blocks ubii.extension.StudyBlock *
12 notes ubii.extension.StudyNote *
message ubii.extension.StudyRunChangeRequest
1 client_id string
2 run_id string
3 action ubii.extension.StudyRunAction
4 block int32
5 is_forced bool
6 text string
7 consent_version int32
message ubii.extension.StudyRunList
1 elements ubii.extension.StudyRun *
message ubii.extension.StudyRunListRequest
1 study_id string
2 participant_code string
message ubii.extension.StudyRunNews
1 run_id string
2 study_id string
3 revision int32
4 block int32
5 recording_id string
6 elapsed_ms double
7 block_ms double
message ubii.extension.StudyRunRequest
1 id string
message ubii.extension.StudyRunStartRequest
1 client_id string
2 study_id string
3 participant_code string
4 visit string
message ubii.extension.StudyStatus
1 runs ubii.extension.StudyRunNews *
2 check_lists ubii.extension.StudyCheckList *
3 list_revision int32
message ubii.extension.StudyTake
1 recording_id string
2 name string
3 run_number int32
4 started_ms double
5 ended_ms double
6 forced string
7 problem string
message ubii.extension.SubscribedModule
1 name string
2 session_id string
3 session_name string
4 node_id string
message ubii.extension.TakenMark
1 name string
2 mark ubii.extension.Mark
message ubii.extension.TopicStatistic
1 topic string
2 data_format string
3 publisher_id string
4 records double
5 bytes double
6 dropped double
7 published_ms double
8 subscribers int32
9 value_bytes int32
message ubii.extension.TopicStatistics
1 cursor double
2 reset bool
3 elements ubii.extension.TopicStatistic *
4 removed string *
5 master_time_ms double
message ubii.extension.TopicStatisticsRequest
1 cursor double
message ubii.extension.TopicSubscribers
1 topic string
2 count int32
3 client_ids string *
4 modules ubii.extension.SubscribedModule *
message ubii.extension.TopicSubscribersList
1 elements ubii.extension.TopicSubscribers *
message ubii.extension.TopicSubscribersRequest
1 topics string *
message ubii.general.Error
1 title string
2 message string
3 stack string
1000 code string
1001 problems ubii.extension.SessionProblem *
1002 join ubii.extension.JoinRefusal
message ubii.general.ErrorList
1 elements ubii.general.Error *
message ubii.general.Success
1 title string
2 message string
message ubii.general.SuccessList
1 elements ubii.general.Success *
message ubii.processing.LockstepProcessingReply
1 processing_module_ids string *
2 records ubii.topicData.TopicDataRecord *
1000 pass int32
1001 session_id string
message ubii.processing.LockstepProcessingRequest
1 processing_module_ids string *
2 records ubii.topicData.TopicDataRecord *
3 delta_time_ms int32
1000 pass int32
1001 session_id string
1002 delta_time double
message ubii.processing.ModuleIO
1 internal_name string
2 message_format string
3 is_record_list bool
1000 default_json string
1001 description string
1002 choices string *
message ubii.processing.ProcessingMode
1 frequency ubii.processing.ProcessingMode.Frequency mode
2 lockstep ubii.processing.ProcessingMode.Lockstep mode
3 trigger_on_input ubii.processing.ProcessingMode.TriggerOnInput mode
4 free ubii.processing.ProcessingMode.Free mode
message ubii.processing.ProcessingMode.Free
message ubii.processing.ProcessingMode.Frequency
1 hertz int32
message ubii.processing.ProcessingMode.Lockstep
1 process_request_endpoint string
message ubii.processing.ProcessingMode.TriggerOnInput
1 min_delay_ms int32
2 all_inputs_need_update bool
message ubii.processing.ProcessingModule
1 id string
2 name string
3 authors string *
4 tags string *
5 description string
6 node_id string
7 session_id string
8 status ubii.processing.ProcessingModule.Status
9 processing_mode ubii.processing.ProcessingMode
10 inputs ubii.processing.ModuleIO *
11 outputs ubii.processing.ModuleIO *
12 language ubii.processing.ProcessingModule.Language
13 on_processing_stringified string
14 on_created_stringified string
15 on_halted_stringified string
16 on_destroyed_stringified string
1000 extension ubii.extension.ModuleExtension
message ubii.processing.ProcessingModuleList
1 elements ubii.processing.ProcessingModule *
message ubii.servers.Server
1 id string
2 name string
3 ip_ethernet string
4 ip_wlan string
5 port_service_zmq string
6 port_service_rest string
7 port_topic_data_zmq string
8 port_topic_data_ws string
9 constants_json string
10 external_address_service_zmq string
11 external_address_service_http_json string
12 external_address_service_http_binary string
13 external_address_topic_data_zmq string
14 external_address_topic_data_ws string
message ubii.services.Service
1 topic string
2 request_message_format string
3 response_message_format string
4 tags string *
5 description string
message ubii.services.ServiceList
1 elements ubii.services.Service *
message ubii.services.ServiceReply
1 success ubii.general.Success type
2 error ubii.general.Error type
3 client ubii.clients.Client type
4 device ubii.devices.Device type
5 server ubii.servers.Server type
6 session ubii.sessions.Session type
7 session_list ubii.sessions.SessionList type
8 processing_module ubii.processing.ProcessingModule type
9 processing_module_list ubii.processing.ProcessingModuleList type
10 string_list ubii.dataStructure.StringList type
11 topic_mux ubii.devices.TopicMux type
12 topic_mux_list ubii.devices.TopicMuxList type
13 topic_demux ubii.devices.TopicDemux type
14 topic_demux_list ubii.devices.TopicDemuxList type
15 client_list ubii.clients.ClientList type
16 device_list ubii.devices.DeviceList type
17 service ubii.services.Service type
18 service_list ubii.services.ServiceList type
19 lockstep_processing_reply ubii.processing.LockstepProcessingReply type
20 component ubii.devices.Component type
21 component_list ubii.devices.ComponentList type
22 notify_condition ubii.conditions.NotifyCondition type
1000 topic_statistics ubii.extension.TopicStatistics type
1001 master_status ubii.extension.MasterStatus type
1002 node_list ubii.extension.NodeList type
1003 client_report ubii.extension.ClientReport type
1004 limit_list ubii.extension.LimitList type
1005 log_tail ubii.extension.LogTail type
1006 module_version_list ubii.extension.ModuleVersionList type
1007 setting_list ubii.extension.SettingList type
1008 asset_set_list ubii.extension.AssetSetList type
1009 topic_subscribers_list ubii.extension.TopicSubscribersList type
1020 join_check ubii.extension.JoinCheck type
1021 access_grant_created ubii.extension.AccessGrantCreated type
1022 access_grant ubii.extension.AccessGrant type
1023 access_grant_list ubii.extension.AccessGrantList type
1040 audit_log ubii.extension.AuditLog type
1050 recording ubii.extension.Recording type
1051 recording_list ubii.extension.RecordingList type
1052 recording_marker ubii.extension.RecordingMarker type
1053 recording_estimate ubii.extension.RecordingEstimate type
1054 flight_recorder ubii.extension.FlightRecorder type
1055 flight_records ubii.extension.FlightRecords type
1070 replay ubii.extension.Replay type
1071 replay_list ubii.extension.ReplayList type
1080 personal_data ubii.extension.PersonalData type
1085 study ubii.extension.Study type
1086 study_list ubii.extension.StudyList type
1087 study_run ubii.extension.StudyRun type
1088 study_run_list ubii.extension.StudyRunList type
1089 study_check_list ubii.extension.StudyCheckList type
1090 study_participant_list ubii.extension.StudyParticipantList type
1091 study_deletion ubii.extension.StudyDeletion type
1095 master_proof ubii.extension.MasterProof type
1110 bridge_mappings ubii.extension.BridgeMappings type
message ubii.services.ServiceRequest
1 topic string
2 client ubii.clients.Client type
3 device ubii.devices.Device type
4 topic_subscription ubii.services.request.TopicSubscription type
5 session ubii.sessions.Session type
6 session_list ubii.sessions.SessionList type
7 processing_module ubii.processing.ProcessingModule type
8 processing_module_list ubii.processing.ProcessingModuleList type
9 topic_mux ubii.devices.TopicMux type
10 topic_mux_list ubii.devices.TopicMuxList type
11 topic_demux ubii.devices.TopicDemux type
12 topic_demux_list ubii.devices.TopicDemuxList type
13 client_list ubii.clients.ClientList type
14 device_list ubii.devices.DeviceList type
15 lockstep_processing_request ubii.processing.LockstepProcessingRequest type
16 component ubii.devices.Component type
17 component_list ubii.devices.ComponentList type
18 notify_condition ubii.conditions.NotifyCondition type
1000 topic_statistics_request ubii.extension.TopicStatisticsRequest type
1001 master_status_request ubii.extension.MasterStatusRequest type
1002 client_report_request ubii.extension.ClientReportRequest type
1003 client_rename_request ubii.extension.ClientRenameRequest type
1004 client_disconnect_request ubii.extension.ClientDisconnectRequest type
1005 client_throttle_request ubii.extension.ClientThrottleRequest type
1006 log_request ubii.extension.LogRequest type
1007 module_version_request ubii.extension.ModuleVersionRequest type
1008 asset_set_request ubii.extension.AssetSetRequest type
1009 topic_subscribers_request ubii.extension.TopicSubscribersRequest type
1020 join_check_request ubii.extension.JoinCheckRequest type
1021 access_grant_create_request ubii.extension.AccessGrantCreateRequest type
1022 access_grant_revoke_request ubii.extension.AccessGrantRevokeRequest type
1040 audit_log_request ubii.extension.AuditLogRequest type
1050 recording_request ubii.extension.RecordingRequest type
1051 recording_start_request ubii.extension.RecordingStartRequest type
1052 recording_change_request ubii.extension.RecordingChangeRequest type
1053 recording_marker ubii.extension.RecordingMarker type
1054 recording_selection ubii.extension.RecordingSelection type
1055 flight_recorder_settings ubii.extension.FlightRecorderSettings type
1056 flight_recorder_keep_request ubii.extension.FlightRecorderKeepRequest type
1057 flight_records_request ubii.extension.FlightRecordsRequest type
1070 replay_start_request ubii.extension.ReplayStartRequest type
1071 replay_change_request ubii.extension.ReplayChangeRequest type
1072 replay_request ubii.extension.ReplayRequest type
1080 personal_data ubii.extension.PersonalData type
1085 study_request ubii.extension.StudyRequest type
1086 study ubii.extension.Study type
1087 study_run_start_request ubii.extension.StudyRunStartRequest type
1088 study_run_change_request ubii.extension.StudyRunChangeRequest type
1089 study_run_request ubii.extension.StudyRunRequest type
1090 study_run_list_request ubii.extension.StudyRunListRequest type
1091 study_participant_request ubii.extension.StudyParticipantRequest type
1095 master_proof_request ubii.extension.MasterProofRequest type
1110 bridge_mappings_request ubii.extension.BridgeMappingsRequest type
1111 bridge_mappings_change ubii.extension.BridgeMappingsChange type
message ubii.services.request.TopicSubscription
1 client_id string
2 subscribe_topics string *
3 unsubscribe_topics string *
4 subscribe_topic_regexp string *
5 unsubscribe_topic_regexp string *
6 subscribe_components ubii.devices.Component *
7 unsubscribe_components ubii.devices.Component *
1000 max_rate_hz double
message ubii.sessions.IOMapping
1 processing_module_id string
2 input_mappings ubii.sessions.TopicInputMapping *
3 output_mappings ubii.sessions.TopicOutputMapping *
4 processing_module_name string
message ubii.sessions.IOMappingList
1 elements ubii.sessions.IOMapping *
message ubii.sessions.Session
1 id string
2 name string
3 processing_modules ubii.processing.ProcessingModule *
4 io_mappings ubii.sessions.IOMapping *
5 tags string *
6 description string
7 authors string *
8 status ubii.sessions.SessionStatus
9 editable bool
1000 extension ubii.extension.SessionExtension
message ubii.sessions.SessionList
1 elements ubii.sessions.Session *
message ubii.sessions.TopicInputMapping
1 input_name string
2 topic string topic_source
3 topic_mux ubii.devices.TopicMux topic_source
1000 constant_json string
message ubii.sessions.TopicInputMappingList
1 elements ubii.sessions.TopicInputMapping *
message ubii.sessions.TopicOutputMapping
1 output_name string
2 topic string topic_destination
3 topic_demux ubii.devices.TopicDemux topic_destination
message ubii.sessions.TopicOutputMappingList
1 elements ubii.sessions.TopicOutputMapping *
message ubii.topicData.Timestamp
1 seconds int64
2 nanos int32
3 millis int64
message ubii.topicData.TopicData
2 topic_data_record ubii.topicData.TopicDataRecord type
3 topic_data_record_list ubii.topicData.TopicDataRecordList type
4 error ubii.general.Error type
1000 node_message ubii.extension.NodeMessage type
message ubii.topicData.TopicDataRecord
1 topic string
2 timestamp ubii.topicData.Timestamp
3 double double type
4 bool bool type
5 string string type
6 vector2 ubii.dataStructure.Vector2 type
7 vector3 ubii.dataStructure.Vector3 type
8 vector4 ubii.dataStructure.Vector4 type
9 quaternion ubii.dataStructure.Quaternion type
10 matrix3x2 ubii.dataStructure.Matrix3x2 type
11 matrix4x4 ubii.dataStructure.Matrix4x4 type
12 color ubii.dataStructure.Color type
13 touch_event ubii.dataStructure.TouchEvent type
14 key_event ubii.dataStructure.KeyEvent type
15 mouse_event ubii.dataStructure.MouseEvent type
16 myo_event ubii.dataStructure.MyoEvent type
17 pose2D ubii.dataStructure.Pose2D type
18 pose3D ubii.dataStructure.Pose3D type
19 object2D ubii.dataStructure.Object2D type
20 object3D ubii.dataStructure.Object3D type
21 object2D_list ubii.dataStructure.Object2DList type
22 object3D_list ubii.dataStructure.Object3DList type
23 int32 int32 type
24 float float type
25 int32_list ubii.dataStructure.Int32List type
26 float_list ubii.dataStructure.FloatList type
27 double_list ubii.dataStructure.DoubleList type
28 string_list ubii.dataStructure.StringList type
29 bool_list ubii.dataStructure.BoolList type
30 image2D ubii.dataStructure.Image2D type
31 image2D_list ubii.dataStructure.Image2DList type
32 session ubii.sessions.Session type
33 client_id string
34 touch_event_list ubii.dataStructure.TouchEventList type
35 vector2_list ubii.dataStructure.Vector2List type
36 vector3_list ubii.dataStructure.Vector3List type
37 vector4_list ubii.dataStructure.Vector4List type
38 quaternion_list ubii.dataStructure.Quaternion type
39 error ubii.general.Error type
40 device ubii.devices.Device type
41 device_list ubii.devices.DeviceList type
42 component ubii.devices.Component type
43 component_list ubii.devices.ComponentList type
44 session_list ubii.sessions.SessionList type
1000 client ubii.clients.Client type
1001 session_statistics ubii.extension.SessionStatistics type
1002 module_event ubii.extension.ModuleEvent type
1003 extension ubii.extension.RecordExtension
1010 recording_status ubii.extension.RecordingStatus type
1011 replay_list ubii.extension.ReplayList type
1085 study_status ubii.extension.StudyStatus type
message ubii.topicData.TopicDataRecordList
1 elements ubii.topicData.TopicDataRecord *
message ubii.topicData.TopicDataSource
1 topic string type
2 regex string type
3 component ubii.devices.Component type
4 static_record ubii.topicData.TopicDataRecord type
message ubii.topicData.TopicDataSourceList
1 elements ubii.topicData.TopicDataSource *
`;
