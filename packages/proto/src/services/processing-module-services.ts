import { withOptionalPayload, withPayload } from './define-service.ts';

/** Services about processing modules: stored, offered and running ones. */
export const PROCESSING_MODULE_SERVICES = {
  processingModuleDatabaseSave: withPayload(
    '/services/processing_module/database/save',
    'processingModule',
    'processingModule',
    'Stores a processing module.',
    { constant: 'PM_DATABASE_SAVE' },
  ),
  processingModuleDatabaseDelete: withPayload(
    '/services/processing_module/database/delete',
    'processingModule',
    'success',
    'Deletes a stored processing module.',
    { constant: 'PM_DATABASE_DELETE' },
  ),
  processingModuleDatabaseGet: withPayload(
    '/services/processing_module/database/get',
    'processingModule',
    'processingModuleList',
    'Returns the stored processing module of the given name, as a list of one.',
    { constant: 'PM_DATABASE_GET' },
  ),
  processingModuleDatabaseGetList: withOptionalPayload(
    '/services/processing_module/database/get_list',
    'processingModuleList',
    'processingModuleList',
    'Lists stored processing modules and those that clients offer.',
    { constant: 'PM_DATABASE_GET_LIST' },
  ),
  processingModuleDatabaseOnlineGetList: withOptionalPayload(
    '/services/processing_module/database/online/get_list',
    'processingModuleList',
    'processingModuleList',
    'Lists the processing modules of the online library.',
    { constant: 'PM_DATABASE_ONLINE_GET_LIST' },
  ),
  processingModuleDatabaseLocalGetList: withOptionalPayload(
    '/services/processing_module/database/local/get_list',
    'processingModuleList',
    'processingModuleList',
    'Lists the processing modules stored on the master.',
    { constant: 'PM_DATABASE_LOCAL_GET_LIST' },
  ),
  processingModuleRuntimeAdd: withPayload(
    '/services/processing_module/runtime/add',
    'processingModuleList',
    'success',
    'Tells the master that a node has started processing modules.',
    { constant: 'PM_RUNTIME_ADD' },
  ),
  processingModuleRuntimeRemove: withPayload(
    '/services/processing_module/runtime/remove',
    'processingModuleList',
    'success',
    'Tells the master that a node has stopped processing modules.',
    { constant: 'PM_RUNTIME_REMOVE' },
  ),
  processingModuleRuntimeGet: withPayload(
    '/services/processing_module/runtime/get',
    'processingModule',
    'processingModule',
    'Returns the running processing module with the given id.',
    { constant: 'PM_RUNTIME_GET' },
  ),
  processingModuleRuntimeGetList: withOptionalPayload(
    '/services/processing_module/runtime/get_list',
    'processingModuleList',
    'processingModuleList',
    'Lists the running processing modules.',
    { constant: 'PM_RUNTIME_GET_LIST' },
  ),
  processingModuleRegistryAdd: withPayload(
    '/services/processing_module/registry/add_list',
    'processingModuleList',
    'success',
    'Adds processing modules to those a client offers.',
    { constant: 'PM_REGISTRY_ADD' },
  ),
  processingModuleRegistryRemove: withPayload(
    '/services/processing_module/registry/remove_list',
    'processingModuleList',
    'success',
    'Removes processing modules from those a client offers.',
    { constant: 'PM_REGISTRY_REMOVE' },
  ),
} as const;
