import type { ComponentInit, PublishOptions, RegisteredDevice } from '@ubii/client-web';
import type { DataFormatValues, TopicRecord } from '@ubii/proto';
import { onScopeDispose, shallowRef, watch } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { deviceRefusal, refusalOf } from './device-refusal.ts';
import { useFrontTab } from './useFrontTab.ts';

type NameOf<C extends readonly ComponentInit[]> = C[number]['name'];
type FormatOf<C extends readonly ComponentInit[], N> = Extract<
  C[number],
  { readonly name: N }
>['format'];
type ValueOf<C extends readonly ComponentInit[], N> = DataFormatValues[FormatOf<C, N>];

export interface DevicePlan<C extends readonly ComponentInit[]> {
  readonly name: string;
  readonly tags: readonly string[];
  readonly components: C;
  /** Receivers of the records of subscriber components. */
  readonly receivers?: {
    readonly [N in NameOf<C>]?: (value: ValueOf<C, N>, record: TopicRecord) => void;
  };
}

/**
 * This browser as a device, while the calling scope is active; inactive while another tab with the same device is in
 * the foreground. Records published before the registration are dropped, because they would be outdated.
 */
export function useDevice<const C extends readonly ComponentInit[]>(plan: DevicePlan<C>) {
  const { client, isConnected } = useConnection();
  const isRegistered = shallowRef(false);
  let device: RegisteredDevice<C> | undefined;
  let refusal: typeof deviceRefusal.value;
  const { name, tags, components } = plan;
  const isResting = useFrontTab(name);

  /** Incremented with each registration, and with the end of each. */
  let turn = 0;
  function register(): void {
    const mine = ++turn;
    void client.registerDevice({ name, tags, components }).then(
      (registered) => {
        if (mine !== turn) return void registered.close();
        device = registered;
        isRegistered.value = true;
      },
      (error: unknown) => {
        // Viewers get a note in the page header, with a link to other roles.
        if (mine !== turn || client.role === 'viewer') return;
        deviceRefusal.value = refusal = refusalOf(name, error);
      },
    );
  }
  function end(): void {
    turn += 1;
    if (deviceRefusal.value === refusal) deviceRefusal.value = undefined;
    void device?.close();
  }
  watch(isResting, (resting) => {
    isRegistered.value = false;
    if (resting) end();
    else register();
  });
  if (!isResting.value) register();
  onScopeDispose(end);

  // Topics contain the client's id, which may change with a reconnect.
  watch([isConnected, isRegistered], ([connected, registered], _before, onCleanup) => {
    if (!connected || !registered || device === undefined) return;
    const known = device;
    const subscriptions = Object.entries(plan.receivers ?? {}).map(([component, receive]) =>
      known
        .component(component as NameOf<C>)
        .subscribe()
        .onRecord((record) =>
          (receive as (value: unknown, record: unknown) => void)(record.value, record),
        ),
    );
    onCleanup(() => subscriptions.forEach((subscription) => void subscription.close()));
  });

  function publish<N extends NameOf<C>>(
    component: N,
    value: ValueOf<C, N>,
    options?: PublishOptions,
  ): void {
    if (!isResting.value) device?.component(component).publish(value as never, options);
  }

  return {
    isRegistered,
    publish,
    /** Publishes a value measured `ageMs` ago, with its timestamp in the master's time. */
    publishTaken<N extends NameOf<C>>(
      component: N,
      value: ValueOf<C, N>,
      ageMs: number,
      options?: PublishOptions,
    ): void {
      publish(component, value, { ...options, timestampMs: client.masterTime.nowMs() - ageMs });
    },
    /** Ends the topic of a component: it has no value any more. [TD-48] */
    end: (component: NameOf<C>): void => device?.component(component).end(),
    topicOf: (component: NameOf<C>) => device?.component(component).topic,
  };
}
