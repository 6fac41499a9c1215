export { orderOfConditions, williamsDesign, type OrderSubject } from './condition-order.ts';
export {
  labelOf,
  labelOfNumber,
  DEFAULT_NAME_TEMPLATE,
  NAME_PLACEHOLDERS,
  NameTemplate,
  type NameFacts,
} from './name-template.ts';
