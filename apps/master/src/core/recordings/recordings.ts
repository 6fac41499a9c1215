import {
  ServiceError,
  type FlightRecorder,
  type FlightRecorderSettings,
  type Recording,
  type RecordingBudget,
  type RecordingEstimate,
  type RecordingList,
  type RecordingMarker,
  type RecordingSelection,
  type RecordingStudy,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { Caller } from '../access/caller.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { MasterPublisher } from '../info/master-publisher.ts';
import { Hook } from '../hooks/hook.ts';
import type { PersonalLabels } from '../personal-data/personal-labels.ts';
import type { IdSource } from '../ports/id-source.ts';
import type {
  KeptRecording,
  Recorder,
  RecorderState,
  RecordingJob,
  RecordingPage,
  RecordSearch,
} from '@ubii/recording/recorder';
import type { TopicTable } from '../topics/topic-table.ts';
import type { NodeRecordings } from './node-recordings.ts';
import { budgetOf } from './budget.ts';
import { estimate } from './estimate.ts';
import { FlightOrders } from './flight-orders.ts';
import { FlightReads } from './flight-reads.ts';
import { presentEvents } from './present-facts.ts';
import type { MayBeginWith, RecordCollector } from './record-collector.ts';
import { RecordedClocks } from './recorded-clocks.ts';
import { idleState, publishStatus } from './recording-news.ts';
import { RecordingMarks } from './recording-marks.ts';
import { RecordingRoom } from './recording-room.ts';
import { RecordingTargets } from './recording-targets.ts';
import {
  RecordingUploads,
  type NodeUpload,
  type Upload,
  type UploadSender,
  type UploadWish,
} from './recording-uploads.ts';
import { CompiledSelection, type SelectionContext } from './selection.ts';

/** What recordings work with. */
export interface RecordingsContext extends SelectionContext {
  readonly clock: Clock;
  readonly ids: IdSource;
  readonly limits: LimitWatch;
  readonly clients: ClientRegistry;
  readonly topics: TopicTable;
  readonly publisher: MasterPublisher;
  readonly recorder: Recorder;
  readonly collector: RecordCollector;
  readonly atNodes: NodeRecordings;
  readonly personalLabels: PersonalLabels;
  readonly flight: FlightRecorderSettings;
  readonly masterName: string;
  readonly version: string;
}

/** Who does something, as far as recordings keep it. */
export interface RecordingAuthor {
  /** Name of the client; empty when none asks. */
  readonly author: string;
  /** Whose the result is, as `fileMakerOf` says. [RC-66] */
  readonly makerId: string;
}

/** A recording to be made. */
export interface RecordingWish extends RecordingAuthor {
  readonly name: string;
  readonly notes: string;
  /** Of a comparison: id of the recording that is replayed meanwhile. [RP-41] */
  readonly replayedRecordingId?: string;
  /** Which part of a study it is [ST-24]. */
  readonly study?: RecordingStudy;
}

/** What to record, when to stop, and who records. */
export interface RecordingPlan {
  readonly selection: RecordingSelection;
  readonly budget?: RecordingBudget | undefined;
  /** Id of the node; empty for the master. [RC-60] @default the master */
  readonly nodeId?: string;
  /** Of recordings of the master: whether it may begin with the value of a topic. [RC-9] [ST-26] @default with each */
  readonly mayBeginWith?: MayBeginWith;
}

/** All that can be done with recordings and the flight recorder. */
export class Recordings {
  readonly #context: RecordingsContext;
  readonly #flight: FlightOrders;
  readonly #reads: FlightReads;
  readonly #marks: RecordingMarks;
  readonly #room: RecordingRoom;
  readonly #uploads: RecordingUploads;
  readonly #targets: RecordingTargets;
  readonly #clocks: RecordedClocks;
  /** Called before a recording is deleted. */
  readonly onDelete = new Hook<[id: string]>();
  /** Called when recordings were added, changed or deleted. */
  readonly onListChanged = new Hook<[]>();
  /** Last report of the recorder; undefined before the first. */
  #state: RecorderState | undefined = undefined;
  #nodeRevision = 0;

  constructor(context: RecordingsContext) {
    this.#context = context;
    const { recorder, limits } = context;
    this.#targets = new RecordingTargets(limits);
    this.#clocks = new RecordedClocks(context);
    this.#room = new RecordingRoom(recorder, limits);
    this.#flight = new FlightOrders({ ...context, present: () => this.#present() });
    this.#reads = new FlightReads(context);
    this.#marks = new RecordingMarks({ ...context, flight: this.#flight });
    this.#uploads = new RecordingUploads({
      ...context,
      room: this.#room,
      jobOf: (wish) => this.#jobOf(wish),
    });
    recorder.onState((state) => this.#handleState(state));
    context.atNodes.onChange.add((isListChanged) => {
      if (isListChanged) this.#nodeRevision++;
      this.#publish(isListChanged);
    });
  }

  /** @param isWanted whether recordings of this maker are listed; default: all [RC-66] */
  async list(isWanted: (makerId: string) => boolean = () => true): Promise<RecordingList> {
    const { recorder, limits, atNodes } = this.#context;
    const { recordings, makers, sizeBytes, freeBytes } = await recorder.list();
    const maxBytes = limits.limits.recordingsBytes;
    const here = new Set(recordings.map(({ id }) => id));
    const elsewhere = atNodes.list().filter(({ id }) => !here.has(id));
    const elements = [
      ...elsewhere.filter(({ id }) => isWanted(atNodes.makerOf(id))),
      ...recordings.filter(({ id }) => isWanted(makers.get(id) ?? '')),
    ].sort((a, b) => b.startedMs - a.startedMs);
    return { elements, sizeBytes, maxBytes, freeBytes };
  }

  /** @param page of topics and markers; default: none of them [RC-54] */
  get(id: string, page?: RecordingPage): Promise<KeptRecording> {
    return this.#at(id).get(id, page);
  }

  /** Whose a recording is. [RC-66] @throws ServiceError when there is none of this id */
  async makerOf(id: string): Promise<string> {
    return this.#at(id).makerOf(id);
  }

  /** [RC-4] [RC-60] */
  async start(wish: RecordingWish, plan: RecordingPlan): Promise<Recording> {
    const { recorder, collector, limits, topics, atNodes } = this.#context;
    const { selection, nodeId = '', mayBeginWith } = plan;
    const budget = budgetOf(plan.budget, limits.limits);
    await this.#room.require();
    if (nodeId !== '') return atNodes.start(this.#jobOf(wish), { selection, budget }, nodeId);
    const target = this.#targets.beginStart();
    const job = { ...this.#jobOf(wish), target, selection, budget, present: this.#present() };
    collector.flush();
    try {
      const started = recorder.start(job);
      const compiled = new CompiledSelection(selection, this.#context);
      collector.add(target, compiled, topics.values(), mayBeginWith);
      return await started;
    } catch (cause) {
      collector.remove(target);
      throw cause;
    } finally {
      this.#targets.endStart(target);
    }
  }

  /** [RC-5] */
  stop(id: string): Promise<Recording> {
    this.#context.collector.flush();
    return this.#at(id).stop(id);
  }

  delete(id: string): Promise<void> {
    this.onDelete.emit(id);
    return this.#at(id).delete(id);
  }

  /** [RC-63] @throws ServiceError when no node has it */
  fetch(id: string): Promise<Recording> {
    return this.#context.atNodes.upload(id);
  }

  /** [RC-6] */
  change(id: string, name: string, notes: string): Promise<Recording> {
    if (name === '') {
      throw new ServiceError('invalid_argument', 'The recording needs a name. Set `name`.');
    }
    return this.#at(id).change(id, { name, notes });
  }

  /** [RC-20] @param author name of the client that asks */
  mark(wanted: RecordingMarker, author: string, mayChangeAll: boolean): Promise<RecordingMarker> {
    return this.#marks.mark(wanted, author, mayChangeAll);
  }

  /** [RC-15] */
  async estimate(selection: RecordingSelection): Promise<RecordingEstimate> {
    const { freeBytes } = await this.#context.recorder.list();
    const measured = await estimate(this.#context, new CompiledSelection(selection, this.#context));
    return { ...measured, freeBytes };
  }

  flight(): Promise<FlightRecorder> {
    return this.#flight.describe();
  }

  /** [RC-31] */
  setFlight(wanted: FlightRecorderSettings): Promise<FlightRecorder> {
    return this.#flight.change(wanted);
  }

  /** Reads what the flight recorder holds of some topics; nothing while it is off. [RC-36] */
  findInFlight(clientId: string, search: Pick<RecordSearch, 'topics' | 'sinceMs'>) {
    return this.#reads.read(clientId, search);
  }

  /** Drops the records of the flight recorder, which continues. [RC-34] */
  emptyFlight(): Promise<void> {
    return this.#flight.empty();
  }

  /** [RC-32] */
  async keep(wish: RecordingWish): Promise<Recording> {
    this.#flight.requireOn();
    await this.#room.require();
    return this.#flight.keep(this.#jobOf(wish));
  }

  /** [RC-41] @throws ServiceError when the upload is too large or no recording */
  upload(upload: Upload, wish: UploadWish, sender: UploadSender): Promise<Recording> {
    return this.#uploads.take(upload, wish, sender);
  }

  /** The same for what a node recorded. [RC-63] */
  uploadOfNode(upload: NodeUpload, caller: Caller): Promise<Recording> {
    return this.#uploads.takeOfNode(upload, caller);
  }

  /** Closes all files. */
  async close(): Promise<void> {
    this.#context.collector.close();
    await this.#context.recorder.close();
  }

  /** Where a recording is: at a node, or here. */
  #at(id: string): Pick<Recorder, 'get' | 'stop' | 'change' | 'delete'> & {
    makerOf(id: string): string | Promise<string>;
  } {
    const { atNodes, recorder } = this.#context;
    return atNodes.has(id) ? atNodes : recorder;
  }

  #present() {
    const { clients, devices, sessions, clock } = this.#context;
    return presentEvents(clients.values(), devices.list(), sessions(), clock.nowMs());
  }

  #jobOf({ name, ...wish }: RecordingWish): RecordingJob {
    const { ids, clock, masterName, version, personalLabels } = this.#context;
    const time = new Date(clock.nowMs()).toISOString().slice(0, 19).replace('T', ' ');
    return {
      ...wish,
      id: ids.uuid(),
      masterName,
      version,
      personalData: personalLabels.toHeader(),
      name: name === '' ? `${time} UTC` : name,
    };
  }

  #handleState(state: RecorderState): void {
    const { collector } = this.#context;
    for (const target of this.#targets.update(state.targets)) collector.remove(target);
    const isListChanged = state.listRevision !== (this.#state?.listRevision ?? 0);
    this.#state = state;
    this.#clocks.look();
    this.#publish(isListChanged);
  }

  /** [RC-8] */
  #publish(isListChanged: boolean): void {
    const { publisher, atNodes } = this.#context;
    if (isListChanged) this.onListChanged.emit();
    const state = this.#state ?? idleState(this.#flight.settings);
    publishStatus(publisher, {
      ...state,
      running: [...atNodes.running(), ...state.running],
      listRevision: state.listRevision + this.#nodeRevision,
    });
  }
}
