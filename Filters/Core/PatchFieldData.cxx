#include "PatchFieldData.h"

#include "Support/DataContract.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace ransmesh
{
PatchTable readPatches(vtkFieldData* fieldData)
{
  PatchTable patches;
  auto* names = vtkStringArray::SafeDownCast(fieldData->GetAbstractArray(contract::PatchNames));
  auto* types = vtkStringArray::SafeDownCast(fieldData->GetAbstractArray(contract::PatchTypes));
  const vtkIdType count = names ? names->GetNumberOfValues() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    Patch patch{ names->GetValue(i), PatchType::Patch };
    if (types && i < types->GetNumberOfValues())
    {
      patch.type = patchTypeOf(types->GetValue(i)).value_or(PatchType::Patch);
    }
    patches.push_back(patch);
  }
  return patches;
}

void writePatches(const PatchTable& patches, vtkFieldData* fieldData)
{
  vtkNew<vtkStringArray> names;
  vtkNew<vtkStringArray> types;
  names->SetName(contract::PatchNames);
  types->SetName(contract::PatchTypes);
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    names->InsertNextValue(patches[i].name);
    types->InsertNextValue(i == 0 ? "fluid" : std::string(nameOf(patches[i].type)));
  }
  fieldData->AddArray(names);
  fieldData->AddArray(types);
}
} // namespace ransmesh
