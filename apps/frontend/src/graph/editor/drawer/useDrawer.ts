import { useLocalStorage } from '@vueuse/core';
import { computed, type ComputedRef, type Ref } from 'vue';
import { useRoute, useRouter } from 'vue-router';
import {
  SESSION_DRAWERS,
  sessionDrawerLocation,
  sessionLocation,
  type SessionDrawer,
} from '../../../locations/session-location.ts';

/** Limits of the height of the drawer, pixels. */
export const DRAWER_PX = { min: 160, max: 720, usual: 300 };

/** The drawer below the graph; which one is open stands in the address. */
export interface Drawer {
  readonly open: ComputedRef<SessionDrawer | undefined>;
  /** Pixels; stored in this browser. */
  readonly height: Ref<number>;
  /** Opens a drawer, or closes it when it is open. */
  toggle(drawer: SessionDrawer): void;
  show(drawer: SessionDrawer): void;
  close(): void;
}

/** @param id of the session */
export function useDrawer(id: () => string): Drawer {
  const route = useRoute();
  const router = useRouter();
  const open = computed(() => SESSION_DRAWERS.find((one) => one === route.params['drawer']));
  const show = (drawer: SessionDrawer): void =>
    void router.replace(sessionDrawerLocation(id(), drawer));
  const close = (): void => void router.replace(sessionLocation(id()));
  return {
    open,
    height: useLocalStorage('ubii.drawerHeight', DRAWER_PX.usual),
    toggle: (drawer) => (open.value === drawer ? close() : show(drawer)),
    show,
    close,
  };
}
