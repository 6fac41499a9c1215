import { computed, ref, watch, type ComputedRef, type Ref } from 'vue';
import { useRoute } from 'vue-router';
import { isOn, TOOLS } from './pages.ts';

/** Whether the tools of the navigation are unfolded: on request, and when one of them is opened. */
export function useToolsFold(): {
  readonly isOpen: Ref<boolean>;
  /** The page that is shown is a tool. */
  readonly isOnTool: ComputedRef<boolean>;
} {
  const route = useRoute();
  const isOnTool = computed(() => TOOLS.some((page) => isOn(route.path, page)));
  const isOpen = ref(isOnTool.value);
  watch(isOnTool, (isTool) => {
    if (isTool) isOpen.value = true;
  });
  return { isOpen, isOnTool };
}
