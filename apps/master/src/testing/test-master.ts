import { Re2Patterns } from '@ubii/patterns/re2';
import type { PatternCompiler } from '@ubii/patterns';
import {
  decode,
  encode,
  fromJson,
  type Client,
  type Init,
  type ProcessingModule,
  type ServiceReply,
  type ServiceRequest,
} from '@ubii/proto';
import { createMaster } from '../core/master/create-master.ts';
import type { Limits } from '../core/limits/index.ts';
import type { Master } from '../core/master/master.ts';
import { TRUSTED_CALLER, type CallerFacts } from '../core/ports/caller-facts.ts';
import { LogTail } from '../core/counters/log-tail.ts';
import type { ClusterPorts, MasterEndpoints, MasterSettings } from '../core/areas/settings.ts';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import type { AssetStore, SandboxFactory } from '@ubii/pm-sandbox';
import { FakeClock } from '@ubii/timing/testing';
import { FakeAssetSets } from './fake-asset-sets.ts';
import { FakeLan } from './fake-lan.ts';
import { FixedUsage } from './fixed-usage.ts';
import { MemoryAudit } from './memory-audit.ts';
import { recordHere } from '@ubii/recording/recorder';
import { FolderReplays } from '../core/replayer/folder-replays.ts';
import { DEFAULT_LIMITS } from '../core/limits/index.ts';
import { MemoryFolder } from './memory-folder.ts';
import { MemoryDocuments, MemoryStorage, MemoryStudyStorage } from './memory-documents.ts';
import { PlainSecrets } from './plain-secrets.ts';
import { PlainTokens } from './plain-tokens.ts';
import { RecordingLog } from './recording-log.ts';
import { SequentialIds } from './sequential-ids.ts';
import { TestClient } from './test-client.ts';

/** Settings that a test can override. */
export interface TestMasterOptions {
  readonly limits?: Partial<Limits>;
  readonly checks?: MasterSettings['checks'];
  readonly patterns?: PatternCompiler;
  readonly endpoints?: Partial<MasterEndpoints>;
  /** A clock that was there before: for a second run of the master. */
  readonly clock?: FakeClock;
  /** Default: code runs on the thread of the test. */
  readonly sandboxes?: SandboxFactory;
  /** Storage that was there before: for a second run of the master. */
  readonly storage?: MemoryStorage;
  /** Ids that earlier runs gave. */
  readonly idsGiven?: number;
  /** Stored invitations of an earlier run: for a second run of the master. */
  readonly grants?: MemoryDocuments;
  /** Labels of personal data of an earlier run. */
  readonly personalData?: MemoryDocuments;
  /** Studies of an earlier run. */
  readonly studyStorage?: MemoryStudyStorage;
  /** The audit log that was there before: for a second run of the master. */
  readonly audit?: MemoryAudit;
  /** Recordings of an earlier run. */
  readonly recordings?: MemoryFolder;
  /** What the flight recorder keeps. Default: it is off. */
  readonly flightRecorder?: MasterSettings['flightRecorder'];
  /** Trusted modules. Default: none. */
  readonly library?: readonly ProcessingModule[];
  /** Asset sets of trusted modules. Default: none. */
  readonly assets?: AssetStore;
  /** Other masters. Default: none. */
  readonly cluster?: ClusterPorts;
  readonly name?: string;
  readonly installation?: string;
}

/** A whole master in memory, with fakes all around and clients that talk to it directly. */
export class TestMaster {
  readonly clock: FakeClock;
  readonly log = new RecordingLog();
  readonly tokens = new PlainTokens();
  readonly usage = new FixedUsage();
  readonly lan = new FakeLan();
  readonly assetSets = new FakeAssetSets();
  readonly storage: MemoryStorage;
  readonly grants: MemoryDocuments;
  readonly personalData: MemoryDocuments;
  readonly studyStorage: MemoryStudyStorage;
  readonly audit: MemoryAudit;
  readonly recordings: MemoryFolder;
  readonly logTail: LogTail;
  readonly master: Master;

  constructor(options: TestMasterOptions = {}) {
    const { limits = {}, patterns, endpoints, clock, library = [], sandboxes } = options;
    this.clock = clock ?? new FakeClock();
    this.logTail = new LogTail(this.log, () => this.clock.nowMs(), false);
    this.storage = options.storage ?? new MemoryStorage();
    this.grants = options.grants ?? new MemoryDocuments();
    this.personalData = options.personalData ?? new MemoryDocuments();
    this.studyStorage = options.studyStorage ?? new MemoryStudyStorage();
    this.audit = options.audit ?? new MemoryAudit();
    this.recordings = options.recordings ?? new MemoryFolder();
    this.master = createMaster(
      {
        clock: this.clock,
        ids: new SequentialIds(options.idsGiven),
        tokens: this.tokens,
        accessSecrets: new PlainSecrets(),
        grants: this.grants,
        personalData: this.personalData,
        studyStorage: this.studyStorage,
        audit: this.audit,
        log: this.logTail,
        logTail: this.logTail,
        patterns: patterns ?? new Re2Patterns(),
        usage: this.usage,
        lan: this.lan,
        assetSets: this.assetSets,
        sandboxes: sandboxes ?? createInlineSandboxes(),
        ...(options.assets && { assets: options.assets }),
        ...(options.cluster && { cluster: options.cluster }),
        storage: this.storage,
        recorder: recordHere({
          folder: this.recordings,
          clock: this.clock,
          limits: { ...DEFAULT_LIMITS, ...limits },
        }),
        replayFiles: new FolderReplays({ folder: this.recordings, clock: this.clock }),
        library: () => library,
      },
      {
        version: '1.2.3',
        ...(options.name !== undefined && { name: options.name }),
        ...(options.installation !== undefined && { installation: options.installation }),
        limits,
        flightRecorder: options.flightRecorder ?? { isOn: false },
        ...(options.checks && { checks: options.checks }),
        endpoints: () => ({
          ipEthernet: '',
          ipWlan: '',
          portServices: 8102,
          portTopicData: 8104,
          portServicesZmq: 0,
          portTopicDataZmq: 0,
          addresses: [],
          ...endpoints,
        }),
      },
    );
  }

  /** Asks a service; the reply leaves, and the turn ends. Both go through their encoded form. */
  async call(
    init: Init<ServiceRequest>,
    caller: CallerFacts = TRUSTED_CALLER,
  ): Promise<ServiceReply> {
    const bytes = encode('ubii.services.ServiceRequest', init);
    return this.request(decode('ubii.services.ServiceRequest', bytes), caller);
  }

  /** Asks a service with a request as JSON. */
  async callJson(json: unknown): Promise<ServiceReply> {
    return this.request(fromJson('ubii.services.ServiceRequest', json));
  }

  /** Asks a service with a decoded request. */
  async request(
    request: ServiceRequest,
    caller: CallerFacts = TRUSTED_CALLER,
  ): Promise<ServiceReply> {
    let isAnswered = false;
    const promise = this.master.handleServiceRequest(request, caller).then((answer) => {
      isAnswered = true;
      return answer;
    });
    // Long work pauses for other turns: they come, without time passing.
    for (;;) {
      for (let i = 0; i < 10; i++) await Promise.resolve();
      if (isAnswered) break;
      this.clock.advanceSync(0);
    }
    const { reply, afterReply } = await promise;
    afterReply();
    this.clock.endTurnSync();
    return decode('ubii.services.ServiceReply', encode('ubii.services.ServiceReply', reply));
  }

  /** Lets what was promised happen, and time pass: modules run. */
  async pass(durationMs = 0): Promise<void> {
    const stepMs = 5;
    await settle();
    for (let passedMs = 0; ; passedMs += stepMs) {
      this.clock.advanceSync(Math.min(stepMs, Math.max(0, durationMs - passedMs)));
      await settle();
      if (passedMs >= durationMs) return;
    }
  }

  /** A client that knows nothing of our extensions, registered and with an open socket. */
  async legacy(name: string, client: Init<Client> = {}): Promise<TestClient> {
    const registered = await this.register({ name, ...client });
    registered.open();
    return registered;
  }

  /** A client of ours, registered and with an open socket. */
  async extension(name: string, client: Init<Client> = {}): Promise<TestClient> {
    const registered = await this.register({ name, extension: { recordLists: true }, ...client });
    registered.open();
    return registered;
  }

  /** A registered client without a socket. @throws Error with the master's message when it refuses. */
  async register(client: Init<Client>, caller = TRUSTED_CALLER): Promise<TestClient> {
    const reply = await this.call({ topic: '/services/client/registration', client }, caller);
    if (reply.client === undefined) throw new Error(reply.error?.message ?? 'no client');
    return new TestClient(this, client.name ?? '', reply.client, caller);
  }
}

/** Many turns of promises: an instance takes some to be made. */
async function settle(): Promise<void> {
  for (let i = 0; i < 50; i++) await Promise.resolve();
}
