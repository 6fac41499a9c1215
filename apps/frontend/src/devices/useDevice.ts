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
  /** Who is told what comes to the subscribers among the components. */
  readonly receivers?: {
    readonly [N in NameOf<C>]?: (value: ValueOf<C, N>, record: TopicRecord) => void;
  };
}

/**
 * This browser as a device, while the calling scope lives; a tab behind another one with the same device
 * rests. What is published before the master knows the
 * device is let go: it is of the past by then.
 */
export function useDevice<const C extends readonly ComponentInit[]>(plan: DevicePlan<C>) {
  const { client, isConnected } = useConnection();
  const isRegistered = shallowRef(false);
  let device: RegisteredDevice<C> | undefined;
  let refusal: typeof deviceRefusal.value;
  const { name, tags, components } = plan;
  const isResting = useFrontTab(name);

  /** Another number with each registration, and with each end of one. */
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
        // A viewer is told by the header of the page, with the way to another role.
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

  // Topics are made of the client's id, and another connection may give another one.
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
    /** Publishes what was taken `ageMs` ago, with the moment of it in the master's time. */
    publishTaken<N extends NameOf<C>>(
      component: N,
      value: ValueOf<C, N>,
      ageMs: number,
      options?: PublishOptions,
    ): void {
      publish(component, value, { ...options, timestampMs: client.masterTime.nowMs() - ageMs });
    },
    /** Says that a component's topic has no value any more. [TD-48] */
    end: (component: NameOf<C>): void => device?.component(component).end(),
    topicOf: (component: NameOf<C>) => device?.component(component).topic,
  };
}
